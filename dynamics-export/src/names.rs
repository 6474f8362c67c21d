//! Names that a language takes.

use dynamics_symbolic::function::plain;

/// The name, changed if it is one of the words, which a language reserves.
pub(crate) fn free_name(name: &str, words: &str) -> String {
    let name = plain(name);
    let is_reserved = words.split_whitespace().any(|word| word == name);
    let mark = if is_reserved { "_" } else { "" };
    format!("{name}{mark}")
}

/// A name in the letters of a variable and of a file: `TwoLink` as `two_link`.
pub(crate) fn snake_case(name: &str) -> String {
    let mut snake = String::new();
    let mut after_lower = false;
    for letter in plain(name).chars() {
        if letter.is_uppercase() && after_lower {
            snake.push('_');
        }
        after_lower = letter.is_lowercase() || letter.is_ascii_digit();
        if letter.is_alphanumeric() {
            snake.extend(letter.to_lowercase());
        } else {
            snake.push('_');
        }
    }
    if snake.starts_with(|letter: char| letter.is_ascii_digit()) || snake.is_empty() {
        snake.insert(0, '_');
    }
    snake
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_those_of_c() {
        assert_eq!(snake_case("TwoLink"), "two_link");
        assert_eq!(snake_case("Puma560"), "puma560");
        assert_eq!(snake_case("UR5e"), "ur5e");
        assert_eq!(snake_case("my arm.2"), "my_arm_2");
        assert_eq!(snake_case("7bot"), "_7bot");
        assert_eq!(free_name("r#double", "do double"), "double_");
        assert_eq!(free_name("M_PI", crate::c::WORDS), "M_PI_");
    }
}
