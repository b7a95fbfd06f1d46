"""read_hdf5.py FILE NUMBERS: whether h5py reads of an export what the test wrote (exit 0)."""
import json
import sys

try:
    import h5py
    import numpy as np
except ImportError:
    sys.exit(77)

raw = np.fromfile(sys.argv[2])
expected = []
while raw.size:
    count = int(raw[0])
    expected.append(raw[1 : 1 + count])
    raw = raw[1 + count :]

with h5py.File(sys.argv[1]) as file:
    found = [
        file["module/device_t_s"],
        file["module/current_a"],
        file["loadcell/force_n"],
        file["table/torque_nm"],
    ]
    for one, other in zip(expected, found):
        assert one.tobytes() == other[()].tobytes(), other.name
    assert file["loadcell/force_n"].attrs["units"] == "N"
    assert "linear" in file["table/current_a"].attrs["how"]
    assert file.attrs["program"] == "searig test"
    assert json.loads(file["facts"][()])["format"] == "searig-export/1"
    assert np.isnan(file["table/current_a"][()]).sum() == (file["table/module_valid"][()] == 0).sum()
