//! The numbers that everything is compared with.

use testkit::references::Decimal;

#[test]
fn a_sum_keeps_what_its_rounding_loses() {
    let [large, small] = [
        "1.000000000000000000000000e+16",
        "1.234567890123456789012345e-01",
    ]
    .map(|text| Decimal::try_from(text.to_owned()).expect("a number"));
    assert_eq!((large + small).error_of(1e16), -0.123_456_789_012_345_68);
}

#[test]
fn the_error_of_a_double_is_known_beyond_its_own_digits() {
    let tenth = Decimal::try_from("1.000000000000000000000000e-01".to_owned()).expect("a number");
    assert_eq!(tenth.nearest(), 0.1);
    // 0.1 as a double is 0.1000000000000000055511151231257827...
    assert!((tenth.error_of(0.1) - 5.551115123125783e-18).abs() < 1e-30);
    assert!((tenth.error_of(0.1 + 2f64.powi(-56)) - 1.942890293094024e-17).abs() < 1e-30);

    let third = Decimal::try_from("-3.333333333333333333333333333333e-1".to_owned()).expect("one");
    assert!((third.error_of(-1.0 / 3.0) - 1.850371707708594e-17).abs() < 1e-30);

    let zero = Decimal::try_from("0".to_owned()).expect("a number");
    assert!(zero.is_zero());
    assert_eq!(zero.error_of(1e-300), 1e-300);
}
