//! The operations that the README shows are those of the programs.

use std::fs::read_to_string;

/// The lines of the README's first command, beside the counts that the engine's tests hold.
#[test]
fn operations_of_the_readme_are_those_of_the_programs() {
    let root = crate::root();
    let readme = read_to_string(root.join("README.md")).expect("the README");
    let golden = root.join("dynamics-symbolic/tests/golden/counts.txt");
    let golden = read_to_string(golden).expect("the counts");
    let of_robot = golden
        .lines()
        .filter_map(|line| line.strip_prefix("puma560 "));
    let counts: Vec<_> = of_robot.filter_map(words).collect();
    let shown: Vec<_> = readme.lines().filter_map(words).collect();
    assert!(shown.len() >= 3, "{} lines of operations", shown.len());
    for (name, numbers) in shown {
        let count = counts.iter().find(|(other, _)| *other == name);
        let (_, count) = count.unwrap_or_else(|| panic!("no counts of {name}"));
        // Multiplications, additions, divisions, and behind the total the angles.
        assert_eq!([&count[..3], &count[4..]].concat(), numbers, "{name}");
    }
}

/// The name of a function and the numbers behind it, where a line has nothing else.
fn words(line: &str) -> Option<(&str, Vec<u32>)> {
    let mut words = line.split_whitespace();
    let name = words.next().filter(|word| word.contains('_'))?;
    let numbers: Option<Vec<u32>> = words.map(|word| word.parse().ok()).collect();
    numbers
        .filter(|numbers| numbers.len() >= 4)
        .map(|numbers| (name, numbers))
}
