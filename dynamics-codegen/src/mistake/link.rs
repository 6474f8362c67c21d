//! Mistakes about the links that carry joints and frames.

use super::Mistake;
use crate::description::Wanted;
use crate::words::{quoted, shortened};

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
    without_link(frame: &str) [frames: frame(frame, "elbow")]
        "this frame has no link: write {frames}, if `elbow` is the joint whose link carries it, or `base`";
    nameless_frame() "a frame needs a name, and this is none";
    frame_twice(frame: &str => shortened) "there is a frame `{frame}` already";
    frame_named_base() "`base` is the base itself: give the frame another name";
    frame_named_as_joint(frame: &str => shortened)
        "there is a joint `{frame}`: give the frame another name, `{frame}_tip` for example";
    /// `mass_matrix(left_hand)`
    without_frame(function: &str) "`{function}` is about no frame: write `{function}`";
    /// A joint in place of a frame.
    frame_of_joint(function: &str, joint: &str) [frames: frame("hand", joint), asked: function_of(function, "hand")]
        "`{joint}` is a joint: make a frame on its link, {frames}, and request {asked}";
    /// A frame where a table has none.
    no_frames(frame: &str) [frames: frame(frame, "elbow")]
        "there is no frame `{frame}`: make it, {frames}, if `elbow` is the joint whose link carries it";
    /// A function of the tip where several rows carry no other. `tips` are these, or some of them.
    no_tip(function: &str, tips: &[&str]) {count: tips.len(), tips_shown: some(tips), tip: tips[0]}
        [frames: frame("hand", tip), asked: function_of(function, "hand")]
        "`{function}` is about the tip, and {count} joints carry no other, {tips_shown}: make a frame, {frames}, and request \
         {asked}";
    /// The same where there are frames.
    no_tip_but_frames(function: &str, tips: &[&str], frames: &[&str]) {count: tips.len(), tips_shown: some(tips), frames_shown: some(frames), first: frames[0]}
        [asked: function_of(function, first)]
        "`{function}` is about the tip, and {count} joints carry no other, {tips_shown}: request it at a frame, {asked}; there \
         are {frames_shown}";
    /// A tool where there is no tip.
    tool_without_tip(tips: &[&str], link: &str) {count: tips.len(), tips_shown: some(tips)} [frames: frame("tool", link)]
        "a `tool` is at the tip, and {count} joints carry no other, {tips_shown}: write a frame in its place, {frames}";
    /// A function of the tip in a file in which several links end on that of the last joint, or none of them is the tip.
    no_end(function: &str, joint: &str, frames: &[&str]) {frames_shown: some(frames), first: frames[0]}
        [asked: function_of(function, first)]
        "`{function}` is about the tip, and several links end on that of `{joint}`: request it at a frame, {asked}, or name the \
         tip in `chain`; there are {frames_shown}";
    /// A tool in such a file.
    tool_without_end(joint: &str, link: &str) [frames: frame("tool", link)]
        "a `tool` is at the tip, and several links end on that of `{joint}`: name the tip in `chain`, or write a frame in place \
         of the tool, {frames}";
    /// A method's name that something else has.
    method_taken(asked: &Wanted, method: &str, other: &str)
        "`{asked}` is the method `{method}`, which is {other}: give the frame another name";
    /// A frame that nothing needs.
    idle_frame(frame: &str) [asked: function_of("forward_kinematics", frame)]
        "frame `{frame}` has no body, and no function is about it: request one, {asked}, or remove the frame";
    /// `word` is `gamma` or `b`.
    two_places(word: &str)
        "`at` and `{word}` both say where the row begins: remove one of the two";
    /// `gamma` or `b` in a standard table.
    of_modified_tables(word: &str) [at: cell("at: { xyz: [0, 0, b], rpy: [0, 0, gamma] }")]
        "`{word}` is a cell of modified tables: in a standard table write {at}";
}

/// The first words of a list.
fn some(words: &[&str]) -> String {
    let shown = words.len().min(5);
    let end = if shown < words.len() { ", ..." } else { "" };
    quoted(&words[..shown], ", ") + end
}
