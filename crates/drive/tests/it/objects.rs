//! The object dictionary: those of the commissioning, aborts, PDO objects.

use super::{Axis, CODE, at, enabled, read, usual, write};
use drive::{Abort, Access, Address, DataType, Value, parts};
use installation::commission::{cia402, commission};

/// Every object of `commission CODE --for cia402` has the same value, of every code that has data.
#[test]
fn the_objects_of_the_commissioning_have_the_same_values() {
    for code in ["CHA-14A-50-H-M128S", CODE, "CHA-40A-160-H-RES-B", "CHA-17A-80-E-C1024", "CHA-14A-100-N-D2048"] {
        let Ok(parsed) = order_code::parse(code) else { panic!("{code}") };
        let Some(about) = commission(&parsed.code) else { continue };
        let axis = Axis::of(code, 0.5, 0.0);
        let drive = axis.drive();
        let objects = cia402::objects(&about);
        assert!(objects.len() >= 6, "{code}");
        for object in objects {
            let found = drive.read(Address::new(object.index, object.sub)).unwrap();
            assert_eq!(found, Value::Number(i64::from(object.value)), "{code} {:04X}", object.index);
        }
    }
}

#[test]
fn identity_type_and_modes() {
    let axis = usual();
    let drive = axis.drive();
    assert_eq!((read(&drive, 0x1000), read(&drive, 0x6502), read(&drive, 0x1001)), (0x20192, 0b1000_0101, 0));
    assert_eq!(drive.read(at(0x1008)).unwrap(), Value::Text(format!("antrieb {CODE}")));
    assert_eq!(drive.read(Address::new(0x1018, 1)).unwrap(), Value::Number(0));
}

#[test]
fn each_fault_has_its_abort_code() {
    let axis = usual();
    let mut drive = axis.drive();
    let cases = [
        (at(0x6099), 0, Abort::NoObject, 0x0602_0000),
        (Address::new(0x6091, 3), 1, Abort::NoSubIndex, 0x0609_0011),
        (Address::new(0x6040, 1), 1, Abort::NoSubIndex, 0x0609_0011),
        (at(0x6041), 1, Abort::ReadOnly, 0x0601_0002),
        (at(0x1000), 1, Abort::ReadOnly, 0x0601_0002),
        (at(0x6060), 4, Abort::Value, 0x0609_0030),
        (at(0x605A), 3, Abort::Value, 0x0609_0030),
        (at(0x6040), 0x1_0000, Abort::TooHigh, 0x0609_0031),
        (at(0x605E), 3, Abort::TooHigh, 0x0609_0031),
        (at(0x605D), 0, Abort::TooLow, 0x0609_0032),
        (Address::new(0x6091, 2), 0, Abort::TooLow, 0x0609_0032),
    ];
    for (place, value, abort, code) in cases {
        assert_eq!((drive.write(place, value), abort.code()), (Err(abort), code), "{place:04X?}");
    }
    assert_eq!(drive.read(at(0x6099)), Err(Abort::NoObject));
    enabled(&mut drive, 1);
    assert_eq!(drive.write(Address::new(0x6091, 1), 50), Err(Abort::State));
}

/// The way that a master takes: off, empty, entries, number, on.
#[test]
fn a_mapping_is_written_in_its_order() {
    let axis = usual();
    let mut drive = axis.drive();
    let map = |sub| Address::new(0x1A02, sub);
    let on = read_sub(&drive, 0x1802, 1) & !(1 << 31);
    assert_eq!(drive.write(map(1), 0x6041_0010), Err(Abort::State), "the number is not zero");
    drive.write(map(0), 0).unwrap();
    assert_eq!(drive.write(map(1), 0x6041_0020), Err(Abort::NotMappable), "another length");
    assert_eq!(drive.write(map(1), 0x6099_0010), Err(Abort::NoObject));
    assert_eq!(drive.write(map(1), 0x6091_0120), Err(Abort::NotMappable));
    for (sub, mapped) in [(1, 0x6041_0010), (2, 0x6064_0020), (3, 0x606C_0020)] {
        drive.write(map(sub), mapped).unwrap();
    }
    assert_eq!(drive.write(map(0), 3), Err(Abort::TooLongForPdo));
    drive.write(map(0), 2).unwrap();
    drive.write(Address::new(0x1802, 1), on).unwrap();
    assert_eq!(drive.write(map(0), 0), Err(Abort::State), "it is on");
    assert_eq!(drive.write(Address::new(0x1802, 2), 252), Err(Abort::Value));
    // What is received is written: no actual values.
    drive.write(Address::new(0x1602, 0), 0).unwrap();
    assert_eq!(drive.write(Address::new(0x1602, 1), 0x6041_0010), Err(Abort::NotMappable));
}

fn read_sub(drive: &drive::Drive<'_>, index: u16, sub: u8) -> i64 {
    match drive.read(Address::new(index, sub)).unwrap() {
        Value::Number(number) => number,
        Value::Text(text) => panic!("{text}"),
    }
}

/// Values at the start are within their bounds; bytes come back as the number.
#[test]
fn every_object_is_consistent() {
    let axis = usual();
    let drive = axis.drive();
    let mut count = 0;
    for entry in drive.entries() {
        count += 1;
        let [least, most] = entry.range;
        match &entry.usual {
            Value::Number(usual) => {
                assert!((least..=most).contains(usual), "{:04X?}", entry.at);
                for value in [least, *usual, most] {
                    let bytes = parts::bytes(entry.data_type, value);
                    assert_eq!(parts::number(entry.data_type, &bytes), Ok(value), "{:04X?}", entry.at);
                }
            }
            Value::Text(_) => assert_eq!(entry.data_type, DataType::VisibleString),
        }
        let [least_of_type, most_of_type] = entry.data_type.range();
        assert!(least_of_type <= least && most <= most_of_type && drive.read(entry.at).is_ok(), "{:04X?}", entry.at);
        // Sub-object 0 of several is there.
        assert!(entry.at.sub == 0 || drive.read(at(entry.at.index)).is_ok());
    }
    assert!(count > 150, "{count}");
    assert_eq!(parts::number(DataType::Unsigned16, &[1]), Err(Abort::TooShort));
    assert_eq!(parts::number(DataType::Integer8, &[1, 2]), Err(Abort::TooLong));
}

/// A writable object accepts its own value.
#[test]
fn what_is_writable_takes_its_value_of_the_start() {
    let axis = usual();
    let mut drive = axis.drive();
    let list: Vec<_> = drive.entries().cloned().collect();
    for entry in list {
        let is_mapping = matches!(entry.at.index, 0x1600..=0x1603 | 0x1A00..=0x1A03);
        if let (Access::ReadWrite, Value::Number(usual), false) = (entry.access, entry.usual, is_mapping) {
            assert_eq!(drive.write(entry.at, usual), Ok(()), "{:04X?}", entry.at);
        }
    }
    write(&mut drive, 0x6060, 1);
}
