from os import PathLike
from typing import Any, final

from numpy.typing import ArrayLike, NDArray
import numpy as np

def text_of(path: str | PathLike[str]) -> str: ...
@final
class Function:
    def __call__(
        self,
        *arguments: ArrayLike,
        out: NDArray[Any] | None = ...,
        threads: int | None = ...,
        on_singular: str = ...,
        **keywords: ArrayLike,
    ) -> Any: ...
    @property
    def __name__(self) -> str: ...

@final
class Arm:
    def __new__(
        cls,
        path: str | PathLike[str],
        text: str,
        entries: str,
        functions: list[str] | None = None,
        chain: list[str] | None = None,
        ignore: list[str] = ...,
        round_angles: float | None = None,
        fields: list[str] = ...,
    ) -> Arm: ...
    def with_fields(self, values: list[tuple[str, float]]) -> Arm: ...
    @property
    def name(self) -> str: ...
    @property
    def dof(self) -> int: ...
    @property
    def joint_names(self) -> list[str]: ...
    @property
    def joint_limits(self) -> list[list[float]]: ...
    @property
    def field_names(self) -> list[str]: ...
    @property
    def field_values(self) -> list[float]: ...
    @property
    def functions(self) -> list[tuple[str, Function]]: ...
