"""same_arrays.py FOLDER: writes the arrays in FOLDER as a Python user would, and says how long it took.

FOLDER/GROUP/COLUMN.f64 are doubles. Times are of writing alone, the best of five (one for CSV): what
was read and how the arrays were come by is not in them. JSON on stdout, seconds.
"""
import json
import os
import pathlib
import sys
import time

import h5py
import numpy as np
from scipy.io import savemat

folder = pathlib.Path(sys.argv[1])
groups = {
    group.name: {column.stem: np.fromfile(column) for column in sorted(group.iterdir())}
    for group in sorted(folder.iterdir())
    if group.is_dir()
}


def seconds(write, times):
    best = float("inf")
    for _ in range(times):
        file = folder / "python.out"
        start = time.perf_counter()
        write(str(file))
        best = min(best, time.perf_counter() - start)
        os.remove(file)
    return best


def table(name, group):
    np.savetxt(name, np.column_stack(list(group.values())), fmt="%.17g", delimiter=",", header=",".join(group), comments="")


def long_form(name):
    with open(name, "w") as file:  # all streams, a row for each sample: fewer bytes than the long form
        for key, group in groups.items():
            if key != "table":
                np.savetxt(file, np.column_stack(list(group.values())), fmt="%.17g", delimiter=",")


def hdf5(name):
    with h5py.File(name, "w") as file:
        for key, group in groups.items():
            for column, values in group.items():
                file.create_dataset(f"{key}/{column}", data=values).attrs["units"] = "rad"


json.dump(
    {
        "csv table": seconds(lambda name: table(name, groups["table"]), 1),
        "csv --long": seconds(long_form, 1),
        "mat": seconds(lambda name: savemat(name, groups), 5),
        "hdf5": seconds(hdf5, 5),
    },
    sys.stdout,
)
