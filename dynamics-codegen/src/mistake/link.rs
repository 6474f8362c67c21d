//! Mistakes about the links that carry joints and frames.

use super::Mistake;
use crate::words::shortened;

mistakes! {
    /// A joint of that name, where `base` is a word of the table.
    joint_named_base()
        "`base` is the base here, and a joint has this name too: give the joint another name";
    /// A joint on its own link.
    on_itself(joint: &str => shortened)
        "`{joint}` cannot stand on its own link: name the joint whose link carries it, or `base`";
    /// A joint on the link of one that stands below it.
    on_a_row_below(carrier: &str => shortened, joint: &str => shortened)
        "`{carrier}` stands below: move its row above that of `{joint}`, which it carries";
    /// A frame in place of a joint.
    on_a_frame(frame: &str => shortened)
        "`{frame}` is a frame: name the joint whose link carries both, or `base`";
    /// A frame without `on`.
    without_link(frame: &str => shortened) [on: cell("on: elbow")]
        "frame `{frame}` has no link: write {on} with the name of a joint, or `base`";
    frame_twice(frame: &str => shortened) "there is a frame `{frame}` already";
    frame_named_base() "`base` is the base itself: give the frame another name";
    frame_named_as_joint(frame: &str => shortened)
        "there is a joint `{frame}`: give the frame another name, `{frame}_tip` for example";
    /// `word` is `gamma` or `b`.
    two_places(word: &str)
        "`at` and `{word}` both say where the row begins: remove one of the two";
    /// `gamma` or `b` in a standard table.
    of_modified_tables(word: &str) [at: cell("at: { xyz: [0, 0, b], rpy: [0, 0, gamma] }")]
        "`{word}` is a cell of modified tables: in a standard table write {at}";
}
