//! Selects at run time the machine instructions that code runs with.

#[cfg(not(target_arch = "x86_64"))]
use fearless_simd::Fallback;
#[cfg(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64"))]
use fearless_simd::Level;
use fearless_simd::Simd;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use std::hint::black_box;

/// Runs `f` with the machine's vector instructions, for everything inlined into it.
///
/// The code is compiled twice: for the baseline instructions and for AVX2, which is detected at run
/// time. Neither version fuses a multiplication with an addition, so that both give the same bits.
/// AVX-512 is not used: steps in lanes took longer with it.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(always)]
pub fn vectorized<R>(f: impl FnOnce() -> R) -> R {
    match Level::new().as_avx2() {
        Some(avx2) => avx2.vectorize(f),
        None => outlined(f),
    }
}

/// Keeps the rarely used version out of line.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(never)]
fn outlined<R>(f: impl FnOnce() -> R) -> R {
    f()
}

/// Runs `f` directly: on this target, all code is compiled for the vector instructions.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
#[inline(always)]
pub fn vectorized<R>(f: impl FnOnce() -> R) -> R {
    f()
}

/// Code that runs with the machine's vectors, compiled with or without fused multiply-add.
pub(crate) trait Fusing {
    /// The result type.
    type Output;

    /// Runs the code, inlined together with the functions that it calls.
    fn run<S: Simd, const FUSED: bool>(self, simd: S) -> Self::Output;
}

/// Aligns the stack frame that contains it, including its spilled vectors. A vector that crosses
/// the end of a memory page costs some processors as much time as hundreds of others, and where the
/// stack begins is a matter of chance.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[repr(align(64))]
struct Aligned(#[expect(dead_code, reason = "its place is what counts")] u8);

/// Runs `f` with fused multiply-add if the machine has it.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(always)]
pub(crate) fn fused<F: Fusing>(f: F) -> F::Output {
    match Level::new().as_avx2() {
        Some(avx2) => avx2.vectorize(
            #[inline(always)]
            || {
                black_box(&Aligned(0));
                f.run::<_, true>(avx2)
            },
        ),
        None => plainly(f),
    }
}

/// Runs `f` with fused multiply-add: every machine of this kind has it.
#[cfg(target_arch = "aarch64")]
#[inline(always)]
pub(crate) fn fused<F: Fusing>(f: F) -> F::Output {
    match Level::new().as_neon() {
        Some(neon) => f.run::<_, true>(neon),
        None => plainly(f),
    }
}

/// Runs `f` without vector extensions, as nothing is known about the machine.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
#[inline(always)]
pub(crate) fn fused<F: Fusing>(f: F) -> F::Output {
    plainly(f)
}

/// Runs `f` with the baseline instructions, without fused multiply-add.
///
/// The vector library's fallback reorders elements in loops. Compiling them took 250 s of this
/// crate's 560 s.
#[cfg(target_arch = "x86_64")]
#[inline(never)]
pub(crate) fn plainly<F: Fusing>(f: F) -> F::Output {
    let Some(sse2) = Level::baseline().as_sse2() else {
        unreachable!("every x86-64 has SSE2");
    };
    f.run::<_, false>(sse2)
}

/// Runs `f` with the portable fallback, without fused multiply-add.
#[cfg(not(target_arch = "x86_64"))]
#[inline(never)]
pub(crate) fn plainly<F: Fusing>(f: F) -> F::Output {
    f.run::<_, false>(Fallback::new())
}
