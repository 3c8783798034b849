"""What the library has to say when it refuses."""
from typing import Optional


class Error(Exception):
    """A call that failed: its text is one line, what is wrong and what to do.

    code          "INVALID_MESH", "INVALID_FILE", ..: the hc_status of honeycomb.h without HC_ERROR_
    element       the number of the vertex, face or other thing it is about, from 0; None: of nothing
    element_kind  "vertex", "face" or "other"; None: of nothing
    """

    def __init__(self, message: str, code: str = "INVALID_ARGUMENT", element: Optional[int] = None,
                 element_kind: Optional[str] = None) -> None:
        super().__init__(message, code, element, element_kind)
        self.code = code
        self.element = element
        self.element_kind = element_kind

    def __str__(self) -> str:
        return str(self.args[0])
