//! The page as one file.

/// The page with places for what is put into it.
const TEMPLATE: &str = include_str!("../../page/page.html");

/// What draws the page, and what it looks like: made by `dynamics-cli/page/build.mjs`.
const SCRIPT: &str = include_str!("../../page/dist/page.js");
const STYLE: &str = include_str!("../../page/dist/page.css");

/// What differs from robot to robot.
pub(super) struct Page<'p> {
    /// The robot's name.
    pub(super) name: &'p str,
    /// The functions, as a script.
    pub(super) equations: String,
    /// The table, as a script.
    pub(super) table: String,
}

impl Page<'_> {
    /// The whole file.
    pub(super) fn html(&self) -> String {
        let title = escaped(self.name);
        let places = [
            ("{{title}}", title.as_str()),
            ("{{style}}", STYLE),
            ("{{equations}}", &self.equations),
            ("{{table}}", &self.table),
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
        text.push_str(rest);
        text
    }
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
        let page = Page {
            name: "a<b",
            equations: "EQUATIONS {{script}}".to_owned(),
            table: "TABLE".to_owned(),
        };
        let html = page.html();
        assert!(html.contains("<title>a&lt;b</title>"));
        let find = |text: &str| html.find(text).expect("a part");
        assert!(find("EQUATIONS {{script}}") < find("TABLE") && find("TABLE") < find(SCRIPT));
        assert!(html.ends_with("</html>\n") && html.contains(STYLE));
        assert!(!SCRIPT.contains("</script") && !SCRIPT.contains("<!--"));
    }
}
