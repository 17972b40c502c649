//! In place of object stores, in a program that is built without them.

use std::io;
use std::path::Path;

fn none<T>() -> io::Result<T> {
    let why = "this slipgap is built without object stores; `cargo install --path . --features object-store` in its sources builds it with them";
    Err(io::Error::new(io::ErrorKind::Unsupported, why))
}

pub fn list(_: &Path) -> io::Result<Vec<(String, bool)>> {
    none()
}

pub fn read(_: &Path) -> io::Result<Vec<u8>> {
    none()
}

pub fn is_there(_: &Path) -> bool {
    false
}

pub fn write(_: &Path, _: &Path) -> io::Result<()> {
    none()
}

pub fn remove(_: &Path) -> io::Result<()> {
    none()
}
