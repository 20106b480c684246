"""Archard: how surfaces in contact wear away.

>>> import archard
>>> case = archard.Case("pin_on_disc")
>>> case["motion.sliding.load"] = "20 N"
>>> result = case.run()  # doctest: +SKIP
>>> result.history["wear_depth_m"][-1]  # doctest: +SKIP

A :class:`Case` is a built-in name, a file, a TOML text or a dict. Values with a dimension are texts with
their unit, or anything with ``magnitude`` and ``units`` (pint); results are in SI, each column with its unit.
"""

TYPE_CHECKING = False  # That of `typing`, which would take longer to load than the command.

if TYPE_CHECKING:
    from archard._api import *  # noqa: F403
    from archard._api import __all__ as __all__
    from archard._api import open as open
else:
    # NumPy is loaded with the first name: the command, which is in this package too, needs neither.
    def __getattr__(name):
        from importlib import import_module

        return getattr(import_module("archard._api"), name)

    def __dir__():
        return sorted({*globals(), *__getattr__("__all__"), "open"})
