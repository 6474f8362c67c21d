//! Loops that a document tells in words that are not URDF's: `<loop_joint>`, and joints of `<gazebo>` between two links.

use roxmltree::Node;

use crate::finding::{Finding, Severity};
use crate::place::Place;
use crate::words::shortened;

/// A finding for each loop. The robot is the tree of the joints, which is open there.
pub(super) fn warnings(root: Node, links: &[&str], place: impl Fn(Node) -> Place) -> Vec<Finding> {
    let loops = root.descendants().filter(|node| closes_loop(*node, links));
    let warning = |node: Node| {
        let (line, column) = place(node).position();
        let element = node.tag_name().name();
        let name = shortened(node.attribute("name").unwrap_or_default());
        let message = format!(
            " Line {line} of the file closes a loop by `<{element} name=\"{name}\">`, which is left out: the robot is the \
             tree of its `<joint>`s, and open there."
        );
        Finding {
            line,
            column,
            ..Finding::of_all("open_loop", Severity::Warning, message)
        }
    };
    loops.map(warning).collect()
}

fn closes_loop(node: Node, links: &[&str]) -> bool {
    let is_in_gazebo = || {
        let mut around = node.ancestors().skip(1);
        around.any(|element| element.tag_name().name() == "gazebo")
    };
    let is_link = |word: &str| {
        let mut parts = node
            .children()
            .filter(|part| part.tag_name().name() == word);
        let link = parts
            .find_map(|part| part.text())
            .unwrap_or_default()
            .trim();
        // A link of a model in a model is named behind the model.
        let link = link.rsplit("::").next().unwrap_or_default();
        links.contains(&link)
    };
    match node.tag_name().name() {
        "loop_joint" => true,
        "joint" => is_in_gazebo() && is_link("parent") && is_link("child"),
        _ => false,
    }
}
