"""Logs of tribometers."""

import pytest

import archard


def test_a_log_tells_its_rate(tmp_path):
    path = tmp_path / "a.csv"
    rows = "".join(f"{0.5 * row},{0.1 * row + 0.01 * (row * 7 % 11)}\n" for row in range(400))
    path.write_text("distance [m],wear [um]\n" + rows)
    log = archard.read_log(path, values={"load": "5 N"})
    assert log["depth_rate"] == pytest.approx(0.2e-6, rel=1e-3)
    low, high = log["depth_rate_interval"]
    assert low < 0.2e-6 < high
    assert log["load_N"] == 5.0
    assert "--set load" in archard.read_log(path)["refused"]
    with pytest.raises(ValueError, match="no column is called"):
        archard.read_log(path, columns={"wear": "depth"})
