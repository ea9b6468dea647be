"""Tables of numbers: a run's diagnostics, by column."""

from __future__ import annotations

import collections.abc
import csv
import math
import os
import typing

import numpy

from .errors import Error, InputError


class Table(collections.abc.Mapping):
    """Columns by name, numpy arrays of doubles of one length; NaN where a value is undefined.

    A mapping: `table["area"]`, `for name in table`, `dict(table)`, and so pandas.DataFrame(dict(table)).
    """

    def __init__(self, columns: typing.Mapping[str, typing.Any]) -> None:
        self._columns = {name: numpy.asarray(values, dtype=float) for name, values in columns.items()}
        if len({len(values) for values in self._columns.values()}) > 1:
            raise InputError("the columns of a table must have one length, not " + ", ".join(
                f"{name} {len(values)}" for name, values in self._columns.items()))

    def __getitem__(self, name: str) -> numpy.ndarray:
        try:
            return self._columns[name]
        except KeyError:
            raise KeyError(f"{name!r}; there are: {', '.join(self._columns) or 'none'}") from None

    def __iter__(self) -> typing.Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        """The number of columns, as of any mapping; `rows` is that of rows."""
        return len(self._columns)

    def __repr__(self) -> str:
        return f"<Table of {self.rows} rows: {', '.join(self._columns)}>"

    @property
    def rows(self) -> int:
        return len(next(iter(self._columns.values()), ()))

    def row(self, number: int) -> dict[str, float]:
        """One row by column, counted from 0, or back from −1."""
        return {name: float(values[number]) for name, values in self._columns.items()}

    def where(self, rows: typing.Any) -> Table:
        """The rows that a mask or an array of numbers chooses: table.where(table["time"] > 1)."""
        return Table({name: values[rows] for name, values in self._columns.items()})

    def write(self, file: str | os.PathLike[str]) -> None:
        """Comma-separated values, which read_table gives back bit for bit. Raises vesicle.Error."""
        path = os.fspath(file)
        try:
            with open(path, "w", encoding="utf-8") as text:
                text.write(",".join(self) + "\n")
                text.writelines(csv_line(self.row(i).values()) for i in range(self.rows))
        except OSError as error:
            raise Error(f"{path}: can't be written: {error.strerror}") from None


def table_of_rows(names: typing.Sequence[str], rows: typing.Sequence[typing.Sequence[float]]) -> Table:
    """The table of rows as long as there are names."""
    values = numpy.array(rows, dtype=float).reshape(-1, len(names))
    return Table(dict(zip(names, values.T)))


def read_table(file: str | os.PathLike[str]) -> Table:
    """Comma-separated values as `vesicle run` and `vesicle.run` write them: names in the first line, an
    empty field where a value is undefined. Raises vesicle.Error naming the file, and the line that is
    none of numbers."""
    path = os.fspath(file)
    try:
        with open(path, newline="", encoding="utf-8") as text:
            lines = csv.reader(text)
            names: list[str] = next(lines, [])
            rows = [_numbers(fields, names, f"{path}:{lines.line_num}") for fields in lines]
    except (OSError, UnicodeDecodeError) as error:
        raise Error(f"{path}: can't be read: {getattr(error, 'strerror', None) or error}") from None
    if not names:
        raise Error(f"{path}: there is no first line with the names of the columns")
    return table_of_rows(names, rows)


def csv_line(values: typing.Iterable[float]) -> str:
    """A line of such a file: the shortest numbers that read back to the same doubles."""
    return ",".join("" if math.isnan(value) else repr(float(value)).removesuffix(".0")
                    for value in values) + "\n"


def _numbers(fields: list[str], names: list[str], where: str) -> list[float]:
    if len(fields) != len(names):
        raise Error(f"{where}: {len(fields)} fields, but there are {len(names)} columns")
    try:
        return [float(field) if field else math.nan for field in fields]
    except ValueError as error:
        raise Error(f"{where}: {error}") from None
