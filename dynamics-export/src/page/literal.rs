//! Literals of JavaScript inside of an HTML file.

/// A text as a literal. No `<` is left in it, which could end the script that it stands in.
pub(super) fn string(text: &str) -> String {
    format!("{text:?}").replace('<', "\\x3c")
}

/// A number that reads back as the same one.
pub(super) fn number(x: f64) -> String {
    format!("{x:?}")
}

/// An array of what is written already.
pub(super) fn array(entries: impl IntoIterator<Item = String>) -> String {
    let written: Vec<_> = entries.into_iter().collect();
    format!("[{}]", written.join(", "))
}

/// An object of names and of what is written already.
pub(super) fn object<'n>(entries: impl IntoIterator<Item = (&'n str, String)>) -> String {
    let entry = |(name, value)| format!("{name}: {value}");
    let written: Vec<_> = entries.into_iter().map(entry).collect();
    format!("{{{}}}", written.join(", "))
}

/// Either, or `null`.
pub(super) fn option(value: Option<String>) -> String {
    value.unwrap_or_else(|| "null".to_owned())
}

/// A module as a script that stands in a page, with its exports in a global variable: no other script
/// could import it from there. A `<` ahead of a slash or an exclamation mark stands in texts and
/// comments alone, and is written as an escape. Nobody reads the indentation, which is some kilobytes.
pub(super) fn module_with_a_global(module: &str, global: &str) -> String {
    let exported = module.lines().filter_map(|line| {
        let rest = line.strip_prefix("export ")?;
        let rest = ["const ", "function ", "class "]
            .iter()
            .find_map(|keyword| rest.strip_prefix(keyword))?;
        rest.split(|letter: char| !(letter.is_alphanumeric() || letter == '_' || letter == '$'))
            .next()
    });
    let exported: Vec<_> = exported.collect();
    let lines: Vec<_> = module.lines().map(str::trim_start).collect();
    let module = lines.join("\n").replace("</", "<\\/").replace("<!", "<\\!");
    format!(
        "{module}\nglobalThis.{global} = {{ {} }};\n",
        exported.join(", ")
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_text_ends_a_script() {
        assert_eq!(
            string("</script> \"joint\" \\ 1\n"),
            r#""\x3c/script> \"joint\" \\ 1\n""#
        );
        assert_eq!(string("Gelenk \u{e9} \u{1}"), "\"Gelenk \u{e9} \\u{1}\"");
    }

    #[test]
    fn exports_are_handed_out() {
        let module = "/** </script> */\nexport const DOF = 1;\nexport function mass_matrix(q) {\n}\nfunction sign(x) {\n}\nexport class E extends Error {\n}\n";
        let script = module_with_a_global(module, "g");
        assert!(script.ends_with("\nglobalThis.g = { DOF, mass_matrix, E };\n"));
        assert!(!script.contains("</"), "{script}");
    }
}
