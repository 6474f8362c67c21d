//! The quantities for which the project has set itself goals, measured: `benches/goals.sh` builds this program for the
//! processor at hand, runs it in turn with a trial outside of Rust, and prints a table of goals, met or missed.

mod measure;
mod second;
mod table;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["one-core"] => {
            measure::on_one_core();
            second::derivatives();
        }
        ["all-cores"] => measure::on_all_cores(),
        ["table", lanes, lines] => table::print(lanes, lines),
        _ => panic!("`one-core`, `all-cores`, or `table`, a number of lanes and a file of lines"),
    }
}
