"""ray_unwrap.py with a stand-in for Ray that runs tasks one after the other: argument 1 is its folder."""

import pickle
import sys
import types

ray = types.ModuleType("ray")
most = 0
waiting = []


def remote(**settings):
    assert settings["num_cpus"] == 1

    def wrap(function):
        def start(*arguments):
            global most
            # Like Ray, across processes.
            task = (function, pickle.dumps(arguments))
            waiting.append(task)
            most = max(most, len(waiting))
            return task

        function.remote = start
        return function

    return wrap


def wait(tasks, num_returns):
    assert num_returns == 1
    return [tasks[-1]], tasks[:-1]


def get(task):
    waiting.remove(task)
    function, arguments = task
    return pickle.loads(pickle.dumps(function(*pickle.loads(arguments))))


ray.remote, ray.wait, ray.get = remote, wait, get
sys.modules["ray"] = ray
sys.path.insert(0, sys.argv[1])

import abflat  # noqa: E402
from ray_unwrap import unwrap_all  # noqa: E402

square = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]


def meshes():
    for i in range(12):
        yield f"good {i}", [[x + i, y, z] for x, y, z in square], [[0, 1, 2, 3]]
    yield "broken", square, [[0, 1, 9]]


results = list(unwrap_all(meshes(), in_flight=5, padding=4))
assert most == 5, most
assert sorted(name for name, _, _ in results) == sorted(name for name, _, _ in meshes())
for name, result, error in results:
    if name == "broken":
        assert result is None and isinstance(error, abflat.AbflatError), error
    else:
        assert error is None and result.report["valid"], name
print("all done")
