"""read_mat.py FILE NUMBERS: whether SciPy reads of an export what the test wrote (exit 0)."""
import json
import sys

try:
    import numpy as np
    from scipy.io import loadmat
except ImportError:
    sys.exit(77)

raw = np.fromfile(sys.argv[2])
expected = []
while raw.size:
    count = int(raw[0])
    expected.append(raw[1 : 1 + count])
    raw = raw[1 + count :]

file = loadmat(sys.argv[1], simplify_cells=True)
found = [
    file["module"]["device_t_s"],
    file["module"]["current_a"],
    file["loadcell"]["force_n"],
    file["table"]["torque_nm"],
]
for one, other in zip(expected, found):
    assert one.tobytes() == np.ascontiguousarray(other).tobytes()
assert file["units"]["loadcell"]["force_n"] == "N"
assert "linear" in file["how"]["table"]["current_a"]
assert json.loads(file["provenance"]["facts"])["format"] == "searig-export/1"
assert "device_a_b" in file and "device_a_b_2" in file
