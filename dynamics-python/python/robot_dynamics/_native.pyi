from collections.abc import Callable
from inspect import Signature
from os import PathLike
from typing import Any, final

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["Arm", "Function", "require_unmasked", "text_of"]

def text_of(path: str | PathLike[str]) -> str: ...
def require_unmasked(name: str, given: object, axes: int) -> None: ...
@final
class Function:
    """A function of a robot. It is derived at its first call, and kept.

    Its own documentation has the arguments with shapes and units: `help(arm.inverse_dynamics)`. Settings of a call:

    out: an array of numpy, which takes the value; it may be an argument, or share its memory
    threads: how many threads share the states, at most as many as there are processors, 1 where nothing is said
    on_singular: "raise" raises `SingularMassMatrix` where M(q) is singular, "nan" gives NaN at these states
    """

    def __call__(
        self,
        *arguments: ArrayLike,
        out: NDArray[Any] | None = None,
        threads: int | None = None,
        on_singular: str = "raise",
        **keywords: ArrayLike,
    ) -> Any: ...
    def bound(self, *arguments: ArrayLike, **keywords: ArrayLike) -> Any: ...
    @property
    def arguments(self) -> list[str]: ...
    @property
    def __name__(self) -> str: ...
    @property
    def __signature__(self) -> Signature: ...

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
        fields: list[str] | None = None,
    ) -> Arm: ...
    def with_fields(self, values: list[tuple[str, float]]) -> Arm: ...
    def identified(
        self,
        base_parameters: list[float],
        friction: list[list[float]] | None = None,
    ) -> Arm: ...
    def nearest_possible(self, base_parameters: list[float]) -> tuple[list[float], float]: ...
    def operations(self, function: str) -> tuple[int, int, int, int, int]: ...
    def formulas(self, function: str, format: str, terms: int) -> tuple[list[str], list[str]]: ...
    def source(
        self, language: str, functions: list[str], scalar: str | None, sines: str | None, project: bool
    ) -> list[tuple[str, str]]: ...
    def page(self) -> str: ...
    def check(self, samples: int) -> tuple[str, bool, list[tuple[str, float, float]]]: ...
    def reach(
        self, asked: dict[str, Any]
    ) -> tuple[list[tuple[list[float], float, float]], tuple[str, bool] | None]: ...
    def simulate(
        self,
        plan: dict[str, Any],
        law: Callable[..., ArrayLike] | None,
        constant: list[float],
    ) -> tuple[dict[str, Any], tuple[float, str, bool] | None]: ...
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
    @staticmethod
    def known_functions() -> list[str]: ...
    @property
    def functions(self) -> list[tuple[str, Function]]: ...
