//! Which of the machine's instructions code is compiled for, chosen when it runs.

#[cfg(not(target_arch = "x86_64"))]
use fearless_simd::Fallback;
#[cfg(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64"))]
use fearless_simd::Level;
use fearless_simd::Simd;
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
use std::hint::black_box;

/// Runs `f` with the machine's vector instructions, as far as what it calls is inlined into it.
///
/// The same code is compiled twice, for the instructions that every machine has and for AVX2, which is
/// looked for at run time. Neither fuses a multiplication with an addition, so that both give the same
/// bits. AVX-512 is left alone: steps in lanes took longer with it.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(always)]
pub fn vectorized<R>(f: impl FnOnce() -> R) -> R {
    match Level::new().as_avx2() {
        Some(avx2) => avx2.vectorize(f),
        None => outlined(f),
    }
}

/// Keeps what most machines never run out of the way of what they do.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[inline(never)]
fn outlined<R>(f: impl FnOnce() -> R) -> R {
    f()
}

/// Runs `f`: this machine's vector instructions are those that everything is compiled for.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64")))]
#[inline(always)]
pub fn vectorized<R>(f: impl FnOnce() -> R) -> R {
    f()
}

/// What runs with the machine's vectors, and is compiled for its fused multiplication and addition or without.
pub(crate) trait Fusing {
    /// What comes out.
    type Output;

    /// Runs it; inlined, as far as what it calls is.
    fn run<S: Simd, const FUSED: bool>(self, simd: S) -> Self::Output;
}

/// What lies in a frame so makes the whole of it begin there, with all that is put by in it: a vector across the end of a
/// page of memory takes some processors as long as hundreds of others, and which ones lie so depends on where the
/// stack happens to begin.
#[cfg(any(target_arch = "x86", target_arch = "x86_64"))]
#[repr(align(64))]
struct Aligned(#[expect(dead_code, reason = "its place is what counts")] u8);

/// Runs it with fused multiplication and addition where the machine has that.
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

/// The same where every machine of the kind has it.
#[cfg(target_arch = "aarch64")]
#[inline(always)]
pub(crate) fn fused<F: Fusing>(f: F) -> F::Output {
    match Level::new().as_neon() {
        Some(neon) => f.run::<_, true>(neon),
        None => plainly(f),
    }
}

/// Runs it: nothing is known of the machine.
#[cfg(not(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64")))]
#[inline(always)]
pub(crate) fn fused<F: Fusing>(f: F) -> F::Output {
    plainly(f)
}

/// Runs it with the instructions that every machine of the kind has, without fused multiplication and addition.
///
/// The vector library's fallback reorders elements in loops. Compiling them took 250 s of this crate's 560 s.
#[cfg(target_arch = "x86_64")]
#[inline(never)]
pub(crate) fn plainly<F: Fusing>(f: F) -> F::Output {
    let Some(sse2) = Level::baseline().as_sse2() else {
        unreachable!("every x86-64 has SSE2");
    };
    f.run::<_, false>(sse2)
}

/// Runs it as it runs on any machine.
#[cfg(not(target_arch = "x86_64"))]
#[inline(never)]
pub(crate) fn plainly<F: Fusing>(f: F) -> F::Output {
    f.run::<_, false>(Fallback::new())
}
