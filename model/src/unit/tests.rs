//! Units as they are written and what they are worth.

use super::{Unit, parse_unit_text, parse_value};

#[track_caller]
fn check(text: &str, si: f64, symbol: &str) {
    let value = parse_value(text).unwrap();
    assert_eq!(value.si(), si, "{text}");
    assert_eq!(value.unit.map_or(String::new(), |unit| unit.symbol), symbol, "{text}");
}

#[test]
fn values_are_exact() {
    check("75 mm", 0.075, "mm");
    check("0.1 [kg m^2]", 0.1, "kg m^2");
    check("20980 N m/rad", 20980.0, "N m/rad");
    check("1 kgf", 9.80665, "kgf");
    check("3e5 [1/(m^2 s^2)]", 3e5, "1/(m^2 s^2)");
    check("180deg", std::f64::consts::PI, "deg");
    check("30rpm", std::f64::consts::PI, "rpm");
    check("2 min", 120.0, "min");
    check("-1.5e-3mm", -1.5e-6, "mm");
    check("5", 5.0, "");
    check("4 [m^(1/2)]", 4.0, "m^(1/2)");
    check("7 um", 7e-6, "um");
    check("3 [J/(kg K)]", 3.0, "J/(kg K)");
}

#[track_caller]
fn check_error(text: &str, expected: &str) {
    let error = parse_value(text).unwrap_err().to_string();
    assert!(error.contains(expected), "{text}: {error}");
}

#[test]
fn wrong_units_are_explained() {
    check_error("5 furlong", "`furlong` is not a unit");
    check_error("5 in", "write `inch`");
    check_error("5 rmp", "did you mean `rpm`?");
    check_error("five mm", "does not begin with a number");
    check_error("5 [J/kg K]", "J/(kg K)");
    check_error("5 mm mm^", "exponent");
    check_error("90 deg deg", "`deg deg` is a product of angles; write one unit");
    check_error("90 deg rad", "product of angles");
    assert!(parse_value("9 [deg^2]").is_ok() && parse_value("9 [deg rad]").is_ok());
    assert!(parse_value("9 N m/rad").is_ok());
}

#[test]
fn dimensions_get_the_units_that_engineers_use() {
    for symbol in ["N m", "kg m^2", "1/s^2", "m/N", "N s/m", "kg^2 m/s^5"] {
        let unit = parse_unit_text(symbol).unwrap();
        assert_eq!(Unit::for_dimension(&unit.dimension).symbol.replace("m kg^2", "kg^2 m"), symbol);
    }
}
