//! Loops that a document tells in words that are not URDF's: `<loop_joint>`, and joints of `<gazebo>` between two links.

use roxmltree::Node;

use super::document::Link;
use crate::note::{Note, Severity};
use crate::place::Place;
use crate::words::shortened;

/// A note on each loop. The robot is the tree of the joints, which is open there.
pub(super) fn warnings(root: Node, links: &[Link], place: impl Fn(Node) -> Place) -> Vec<Note> {
    let loops = root.descendants().filter(|node| closes_loop(*node, links));
    let warning = |node: Node| {
        let (line, column) = place(node).position();
        let element = node.tag_name().name();
        let name = shortened(node.attribute("name").unwrap_or_default());
        let text = format!(
            " Line {line} of the file closes a loop by `<{element} name=\"{name}\">`, which is left out: the robot is the \
             tree of its `<joint>`s, and open there."
        );
        Note::new("open_loop", Severity::Warning, text).at(line, column)
    };
    loops.map(warning).collect()
}

fn closes_loop(node: Node, links: &[Link]) -> bool {
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
        links.iter().any(|known| known.name == link)
    };
    match node.tag_name().name() {
        "loop_joint" => true,
        "joint" => is_in_gazebo() && is_link("parent") && is_link("child"),
        _ => false,
    }
}
