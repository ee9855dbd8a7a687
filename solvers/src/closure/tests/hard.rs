//! Hard cases: what must stay stable, beside the failure of the naive way.
