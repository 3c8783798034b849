"""The C++ of the pages as sources to compile: extract_code.py ROOT OUT.

Whole programs (with a main) become OUT/program_PAGE_LINE.cpp each. All else becomes the bodies of tests in
OUT/fragments.cpp, where the names of tests/docs/fragment.h are known; #include lines go to the top. Files that would be
the same are left alone.
"""
import pathlib
import re
import sys

import markdown


def write(path, text):
    if not path.exists() or path.read_text(encoding="utf-8") != text:
        path.write_text(text, encoding="utf-8")


def name_of(block):
    return re.sub(r"\W", "_", block.page.removesuffix(".md")) + f"_line_{block.line}"


def located(block, root, code):
    return f'#line {block.line} "{root / block.page}"\n{code}'


def parted(code):
    """The #include lines, and the rest with empty lines in their places."""
    lines = code.splitlines(keepends=True)
    included = [line for line in lines if line.startswith("#include")]
    return "".join(included), "".join("\n" if line.startswith("#include") else line for line in lines)


def fragments(blocks, root):
    includes, bodies = '#include "tests/docs/fragment.h"\n', ""
    for block in blocks:
        included, body = parted(block.runnable())
        includes += included
        bodies += f"\nTEST_F(Documentation, {name_of(block)}) {{\n{located(block, root, body)}}}\n"
    return includes + bodies


def main():
    root, out = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    out.mkdir(parents=True, exist_ok=True)
    blocks = [block for page in markdown.pages(root) for block in page.blocks
              if block.language == "cpp" and block.rule != "not run"]
    programs = [block for block in blocks if re.search(r"\bint main\(", block.code)]
    wanted = {f"program_{name_of(block)}.cpp": located(block, root, block.runnable()) for block in programs}
    wanted["fragments.cpp"] = fragments([block for block in blocks if block not in programs], root)
    for old in out.glob("*.cpp"):
        if old.name not in wanted:
            old.unlink()
    for name, text in wanted.items():
        write(out / name, text)


if __name__ == "__main__":
    main()
