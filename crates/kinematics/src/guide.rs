//! How krank finds what it shows: a page for each room of the solver, with its derivations.
//!
//! Each page is the introduction of its room in the source as well. The symbols are those of the
//! [front page](crate#notation); what can be asked of it all stands at [`solver`](crate::solver).

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
