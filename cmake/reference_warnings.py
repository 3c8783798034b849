"""Fails where public headers leave something undescribed: reference_warnings.py LOG of doxygen's warnings.

Types, enumerations, functions and constants have comments. What needs none of its own, and is not counted:
    fields of a struct, which its comment describes (one without a comment is a warning by itself)
    what is asked by name alone, name() const, of a type with a comment
    constructors that take what the type's comment speaks of
    special members, operators, iterators, and what a class has as the standard containers have it
    macros, and functions of C that destroy what others made
"""
import pathlib
import re
import sys

NEEDS_NONE = re.compile(r"""
    \(variable\)\ of\ struct
  | \(macro\ definition\) | hc_\w+_destroy\(
  | \w+\(\)\ const\ \((function|friend)\)
  | =\ ?(default|delete)\ \(function\) | ~\w+\( | Member\ (\w+)\(.*\ of\ (class|struct)\ (\w+::)*\3\ is
  | operator([^\w\s(]+|\ bool)\( | Iterator\b | (value_type|iterator|const_iterator)\ \(typedef\)
  | Member\ (begin|end|data|front|back|reserve|push_back|assign|swap)\(
""", re.VERBOSE)


def main():
    lines = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").splitlines()
    left = [line for line in lines if line.strip() and not NEEDS_NONE.search(line)]
    print("\n".join(left))
    sys.exit(f"error: {len(left)} warnings of doxygen" if left else 0)


if __name__ == "__main__":
    main()
