//! The page as one file.

/// The page with places for what is put into it.
const TEMPLATE: &str = include_str!("../../page/page.html");

/// The script that draws the page, and its style: made by `dynamics-export/page/build.mjs`.
const SCRIPT: &str = include_str!("../../page/dist/page.js");
const STYLE: &str = include_str!("../../page/dist/page.css");

/// The whole file of a robot of that name, with the scripts of its functions and of its table.
pub(super) fn html(name: &str, equations: &str, table: &str) -> String {
    let title = escaped(name);
    let places = [
        ("{{title}}", title.as_str()),
        ("{{style}}", STYLE),
        ("{{equations}}", equations),
        ("{{table}}", table),
        ("{{script}}", SCRIPT),
    ];
    let mut text = String::new();
    let mut rest = TEMPLATE;
    for (place, content) in places {
        let (before, after) = rest.split_once(place).unwrap_or((rest, ""));
        text.push_str(before);
        text.push_str(content);
        rest = after;
    }
    text + rest
}

/// A text between tags.
fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_is_put_into_its_place() {
        let html = html("a<b", "EQUATIONS {{script}}", "TABLE");
        assert!(html.contains("<title>a&lt;b</title>"));
        let find = |text: &str| html.find(text).expect("a part");
        assert!(find("EQUATIONS {{script}}") < find("TABLE") && find("TABLE") < find(SCRIPT));
        assert!(html.ends_with("</html>\n") && html.contains(STYLE));
        assert!(!SCRIPT.contains("</script") && !SCRIPT.contains("<!--"));
    }
}
