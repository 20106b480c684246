"""A UM-Bridge server: load (N) and wear coefficient (1/Pa) of a pin in, wear depth (um) out.

    python um_bridge_server.py        # then, from QUEENS, PyMC, MUQ, tinyDA or Python:

    umbridge.HTTPModel("http://localhost:4242", "pin_on_disc")([[10.2, 1.33e-13]])
"""

import archard
import umbridge


class PinOnDisc(umbridge.Model):
    def __init__(self):
        super().__init__("pin_on_disc")

    def get_input_sizes(self, config):
        return [2]

    def get_output_sizes(self, config):
        return [1]

    def __call__(self, parameters, config):
        [[load, coefficient]] = parameters
        case = archard.Case("pin_on_disc")
        case["motion.sliding.load"] = f"{load!r} N"
        case["body.pin.wear.archard.coefficient"] = f"{coefficient!r} 1/Pa"
        return [[1e6 * float(case.run(threads=1).history["wear_depth_m"][-1])]]

    def supports_evaluate(self):
        return True


if __name__ == "__main__":
    umbridge.serve_models([PinOnDisc()], 4242)
