//! Explains how krank computes its results, with derivations: one page per part of the solver.
//!
//! Each page is also the module documentation of that part in the source. The symbols are those of
//! the [front page](crate#notation). The queries are listed at [`solver`](crate::solver).

pub mod elements {
    #![doc = include_str!("guide/elements.md")]
}
pub mod coupled {
    #![doc = include_str!("guide/coupled.md")]
}
pub mod motion {
    #![doc = include_str!("guide/motion.md")]
}
pub mod forces {
    #![doc = include_str!("guide/forces.md")]
}
pub mod derivatives {
    #![doc = include_str!("guide/derivatives.md")]
}
pub mod rank {
    #![doc = include_str!("guide/rank.md")]
}
pub mod transmission {
    #![doc = include_str!("guide/transmission.md")]
}
