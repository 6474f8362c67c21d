//! The measured values for `docs/performance/arms.md`, from the lines that the builds printed.

mod machine;
mod tables;

use measuring::records::Records;

/// Prints conditions and tables. `files` are the lines of the plain build, those of the native build, and
/// those of the programs that are not Rust.
pub(crate) fn print(files: &[String]) {
    let [plain, native, elsewhere] = files else {
        panic!("three files: plain, native, elsewhere");
    };
    let [plain, native, elsewhere] = [plain, native, elsewhere].map(|file| Records::read(file));
    println!("{}\n", machine::conditions());
    println!("{}", elsewhere.remarks());
    println!("## Times and errors\n");
    print!("{}", tables::details(&plain, &native, &elsewhere));
    print!("{}", tables::groups(&plain, &native));
}
