"""read_export.py FILE NUMBERS: whether SciPy or h5py reads of an export what the test wrote (exit 0)."""
import json
import sys

try:
    import h5py
    import numpy as np
    from scipy.io import loadmat
except ImportError:
    sys.exit(77)


def written_by_the_test(name):
    raw = np.fromfile(name)
    while raw.size:
        count = int(raw[0])
        yield raw[1 : 1 + count]
        raw = raw[1 + count :]


def check_numbers(file):
    found = [
        file["module"]["device_t_s"],
        file["module"]["current_a"],
        file["loadcell"]["force_n"],
        file["table"]["torque_nm"],
    ]
    for one, other in zip(written_by_the_test(sys.argv[2]), found):
        assert one.tobytes() == np.ascontiguousarray(other[()]).tobytes()


def check_mat(file):
    check_numbers(file)
    assert file["units"]["loadcell"]["force_n"] == "N"
    assert "linear" in file["how"]["table"]["current_a"]
    assert json.loads(file["provenance"]["facts"])["format"] == "searig-export/1"
    assert "device_a_b" in file and "device_a_b_2" in file


def check_hdf5(file):
    check_numbers(file)
    assert file["loadcell/force_n"].attrs["units"] == "N"
    assert "linear" in file["table/current_a"].attrs["how"]
    assert file.attrs["program"] == "searig test"
    assert json.loads(file["facts"][()])["format"] == "searig-export/1"
    assert np.isnan(file["table/current_a"][()]).sum() == (file["table/module_valid"][()] == 0).sum()


if sys.argv[1].endswith(".mat"):
    check_mat(loadmat(sys.argv[1], simplify_cells=True))
else:
    with h5py.File(sys.argv[1]) as opened:
        check_hdf5(opened)
