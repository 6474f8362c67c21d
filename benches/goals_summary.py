"""The goals on all processors that were met, from the tables that benches/goals.sh wrote.

Usage: goals_summary.py FILE...

Prints a table: for each goal its bar, and in a column for each file what was measured, bold where the bar is missed. The
first row has the compilers and the date of each file.
"""

import re
import sys

ROW = re.compile(r"^\| (.*) \| (\S+) \| (at (?:most|least) \S+) \| (met|\*\*missed\*\*) \|$")


def key(goal):
    """A goal without what differs from run to run: which function is the slowest, and errors."""
    return re.sub(r": `.*| \(errors .*", "", goal)


def main(files):
    heads, conditions, goals = [], [], {}
    for number, file in enumerate(files):
        with open(file, encoding="utf-8") as lines:
            heads.append(next(lines).removeprefix("# Goals on ").strip())
            next(lines)
            conditions.append(next(lines).split("doubles; ")[1].strip().removesuffix("."))
            for row in filter(None, map(ROW.match, lines)):
                goal, measured, bar, verdict = row.groups()
                bars, cells = goals.setdefault(key(goal), ({}, ["–"] * len(files)))
                bars[bar] = None
                cells[number] = measured if verdict == "met" else f"**{measured}**"
    print("| goal | bar |", " | ".join(heads), "|")
    print("|---|---" + "|--:" * len(files) + "|")
    print("| compilers; date | |", " | ".join(conditions), "|")
    for goal, (bars, cells) in goals.items():
        print("|", " | ".join([goal, ", ".join(bars), *cells]), "|")


main(sys.argv[1:])
