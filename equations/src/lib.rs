//! The mechanisms that come with Assur, one equation file each.
//!
//! A new mechanism is a new file beside this one and its name in the list below.

assur::equations! {
    "batten.eqn",
    "batten_table.eqn",
    "heald_linkage.eqn",
    "selvedge_linkage.eqn",
    "feed_rack.eqn",
    "feed_lift.eqn",
    "feed_stitch.eqn",
    "sewing_feed.eqn",
    "dwell_six_bar.eqn",
    "table_drive.eqn",
    "presser_foot.eqn",
    "needle_impact.eqn",
    "engine.eqn",
    "balanced_four_bar.eqn",
    "shaper.eqn",
    "andrews.eqn",
    "feed_dynamics.eqn",
    "car_axis.eqn",
    "governor.eqn",
    "elastic_crank.eqn",
    "simple_pendulum.eqn",
    "four_bar_chain.eqn",
    "four_bar_row.eqn",
    "bricard.eqn",
    "lamp_arm.eqn",
    "packet_reducer.eqn",
    "pumping_jack.eqn",
}
