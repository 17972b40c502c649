//! The `parameters` of a block: axes as lists, rules, intervals of a design, expressions; axes that advance together.

pub(super) mod applicability;
pub(super) mod axis_rule;
pub(super) mod design;
pub(super) mod draft;
pub(super) mod interval;
pub(super) mod parameters;
pub(super) mod zip;
