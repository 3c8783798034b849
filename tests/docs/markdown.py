"""What a page holds that can be checked: code blocks, links, headings, code spans.

A comment right above a code block says what the tests do with it; without one it runs as it stands:
    <!-- not run: WHY -->
    <!-- run with: OLD => NEW; OLD => NEW -->        smaller numbers: each OLD stands in the block
"""
import dataclasses
import re

RULE = re.compile(r"<!--\s*(not run|run with):\s*(.*?)\s*-->\s*$", re.DOTALL)
FENCE = re.compile(r"^```(\w*)\s*$")


@dataclasses.dataclass
class Block:
    page: str  # path from the repository's root
    line: int  # of the first line of code, from 1
    language: str
    code: str
    rule: str = ""  # "not run", "run with" or nothing
    detail: str = ""

    @property
    def place(self):
        return f"{self.page}:{self.line}"

    def runnable(self):
        """The code with the smaller numbers of its rule put in."""
        code = self.code
        for change in filter(None, self.detail.split("; ") if self.rule == "run with" else []):
            old, arrow, new = change.partition(" => ")
            if not arrow or old not in code:
                raise ValueError(f"{self.place}: the rule above the block replaces '{old}', which isn't in it")
            code = code.replace(old, new)
        return code


class Page:
    def __init__(self, path, root):
        self.path = path
        self.name = path.relative_to(root).as_posix()
        self.blocks, self.prose = [], []  # prose: (line number, line), without code blocks and comments
        self._read(path.read_text(encoding="utf-8").splitlines())

    def _read(self, lines):
        block, above = None, []
        for number, line in enumerate(lines, 1):
            fence = FENCE.match(line)
            if block is not None and line.rstrip() == "```":
                self.blocks.append(block)
                block, above = None, []
            elif block is not None:
                block.code += line + "\n"
            elif fence:
                rule = RULE.search("\n".join(above))
                block = Block(self.name, number + 1, fence.group(1), "", *(rule.groups() if rule else ()))
            else:
                self.prose.append((number, line))
                above = above + [line] if line.strip() else []
        if block is not None:
            raise ValueError(f"{block.place}: this code block has no end")

    def links(self):
        """(line, target) of every link and picture."""
        return [(number, target) for number, line in self.prose
                for target in re.findall(r"\]\(([^)\s]+)\)", without_code(line))]

    def spans(self):
        """(line, text) of every code span."""
        return [(number, text) for number, line in self.prose for text in re.findall(r"`([^`]+)`", line)]

    def anchors(self):
        """What #... may follow the page's name: its headings, as GitHub names them."""
        headings = [line.lstrip("#").strip() for _, line in self.prose if re.match(r"#{1,6} ", line)]
        return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def without_code(line):
    return re.sub(r"`[^`]*`", "", line)


def pages(root):
    """README.md and all of docs/."""
    return [Page(path, root) for path in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]]
