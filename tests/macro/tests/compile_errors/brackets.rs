//! Mistakes in Poisson brackets.

use kahan_core::prelude::*;

// The entry {x,x} is wrong, because it is zero for every bracket.
kahan! {
    pub struct Diagonal;
    xdot = y;
    ydot = -x;
    bracket P { {x,x} = 1; {x,y} = 1; }
}

// The entries of {y,x} and {x,y} contradict each other.
kahan! {
    pub struct EntryTwice;
    xdot = y;
    ydot = -x;
    bracket P { {x,y} = 1; {y,x} = -1; }
}

// Every entry must end with `;`.
kahan! {
    pub struct MissingSemicolon;
    xdot = y;
    ydot = -x;
    bracket P { {x,y} = 1 }
}

// The bracket has no entries.
kahan! {
    pub struct NoEntries;
    xdot = y;
    ydot = -x;
    bracket P { }
}

// A bracket has entries for states only, not for parameters.
kahan! {
    pub struct Parameter { w }
    xdot = w*y;
    ydot = -w*x;
    bracket P { {x,w} = 1; }
}

// An entry must be a pair of states.
kahan! {
    pub struct ThreeStates;
    xdot = y;
    ydot = -x;
    bracket P { {x,y,x} = 1; }
}

// An entry must be a pair of states, but `z` is not a state.
kahan! {
    pub struct UnknownState;
    xdot = y;
    ydot = -x;
    bracket P { {x,z} = 1; }
}

// The bracket is written like an integral, without entries.
kahan! {
    pub struct WrittenLikeAnIntegral;
    xdot = y;
    ydot = -x;
    bracket P = 1;
}

fn main() {}
