"""check_life.py: arrays, handles, threads, processes, progress and Ctrl-C."""
import multiprocessing
import os
import resource
import signal
import threading
import time
from concurrent import futures

import manylight

BOX = "scenes/cornell-box.glb"
SIZE = (48, 48)
LONG = bool(os.environ.get("MANYLIGHT_LONG"))


def check_libraries():
    """Python itself loads no OpenGL: it comes with the first device."""
    with open("/proc/self/maps", encoding="utf-8") as maps:
        loaded = maps.read()
    assert "libmanylight" in loaded
    assert not any(name in loaded for name in ("libGL.so", "libEGL.so", "libOSMesa")), loaded


def check_arrays_outlive():
    """Arrays keep their numbers after device, scene and renderer are gone."""
    with manylight.Device(allow_software=True) as device:
        scene = manylight.Scene(BOX)
        with device.renderer(scene, SIZE) as renderer:
            layers = renderer.render()
            again = renderer.render()
        copies = {layer: array.copy() for layer, array in layers.items()}
    del scene, renderer, device
    for layer, array in layers.items():
        assert array.flags.owndata and array.tobytes() == copies[layer].tobytes() == again[layer].tobytes()
        array += 1


def counted_during(work):
    """How far another thread counts while work runs, and its seconds."""
    counting, count = True, 0

    def body():
        nonlocal count
        while counting:
            count += 1
            time.sleep(0)

    thread = threading.Thread(target=body)
    start = time.monotonic()
    thread.start()
    work()
    counting = False
    thread.join()
    return count, time.monotonic() - start


def check_gil(device):
    """A thread counts during a reference and during a render, on whichever thread they are called."""
    for name, work in (("reference", lambda: manylight.reference(BOX, SIZE, samples=64)),
                       ("render", lambda: device.render(BOX, (100, 100), passes=3 if LONG else 2))):
        count, seconds = counted_during(work)
        print(f"    counted to {count} during a {name} of {seconds:.2f} s")
        assert count > 1000


def pictures(device=None):
    """Bytes of a frame and of a reference; None: by a device of its own."""
    if device is None:
        with manylight.Device(allow_software=True) as own:
            return pictures(own)
    scene = manylight.Scene(BOX)
    traced = manylight.reference(scene, (16, 16), samples=2, threads=1)
    return device.render(scene, SIZE)["beauty"].tobytes(), traced["beauty"].tobytes()


def processes(count):
    """Processes as the pages tell to start them."""
    return futures.ProcessPoolExecutor(count, multiprocessing.get_context("spawn"))


def check_threads(device):
    """Threads with a device each, two with one device, and processes make the pictures of one."""
    expected = pictures(device)
    devices = [device] * 2 + [None] * (8 if LONG else 3)
    for pool, owners in ((futures.ThreadPoolExecutor(len(devices)), devices), (processes(4), [None] * (4 if LONG else 2))):
        with pool:
            assert list(pool.map(pictures, owners)) == [expected] * len(owners)


def limited(leaves):
    """What a device says where `ulimit -v` leaves so many bytes."""
    with open("/proc/self/statm", encoding="utf-8") as statm:
        most = int(statm.read().split()[0]) * os.sysconf("SC_PAGE_SIZE") + leaves
    resource.setrlimit(resource.RLIMIT_AS, (most, most))
    try:
        return len(pictures())
    except manylight.OutOfMemory as error:
        return str(error)


def check_memory():
    """Too little memory is an exception that names the limit."""
    with processes(1) as small, processes(1) as large:
        assert "too little memory: ulimit -v leaves" in small.submit(limited, 300 << 20).result()
        assert large.submit(limited, 16 << 30).result() == 2


def check_progress(device):
    """Progress goes from above 0 to 1; an exception of it comes out of the call, after which the renderer works."""
    reports = []
    with device.renderer(BOX, SIZE, passes=4) as renderer:
        first = renderer.render(progress=lambda done, note: reports.append((done, note)))
        print(f"    {reports}")
        ends = list(dict.fromkeys(done for done, _ in reports if done))  # A slow machine reports within passes too.
        assert ends == [.25, .5, .75, 1] and reports[-1] == (1, "pass 4 of 4")

        def stop(done, note):
            raise KeyError("enough")

        try:
            renderer.render(progress=stop)
            raise AssertionError("not stopped")
        except KeyError as error:
            assert error.args == ("enough",)
        try:
            renderer.render(progress=lambda done, note: renderer.render())
            raise AssertionError("not refused")
        except manylight.ArgumentError as error:
            print(f"    {error}")
        assert renderer.render()["beauty"].tobytes() == first["beauty"].tobytes()


def interrupt(work):
    """Ctrl-C during some work, which it must end long before it is done."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # which jobs of shells in the background ignore
    timer = threading.Timer(.5, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    start, spent = time.monotonic(), time.process_time()
    try:
        work()
        raise AssertionError("not interrupted")
    except KeyboardInterrupt:
        spent = time.process_time() - spent
        print(f"    interrupted after {time.monotonic() - start:.2f} s, {spent:.2f} s of the processor")
        assert spent < 15  # without an end the pass takes 90 s


def check_interrupt(device):
    """Ctrl-C ends a long pass and a long reference soon."""
    with device.renderer(BOX, (100, 100), technique="instant-radiosity", vpls=256) as small:
        expected = small.render()["beauty"].tobytes()
        interrupt(lambda: [small.render() for _ in range(1000)])
        assert small.render()["beauty"].tobytes() == expected
    interrupt(lambda: device.render(BOX, (200, 200), technique="instant-radiosity", vpls=16384))
    interrupt(lambda: manylight.reference(BOX, (200, 200), samples=4000))
    spent = time.process_time()
    time.sleep(.3)
    spent = time.process_time() - spent
    print(f"    {spent:.3f} s of the processor after it")
    assert spent < .1, "the work goes on"


def ended(child, seconds=20):
    """The exit status of a child process, which must not hang."""
    start = time.monotonic()
    while time.monotonic() - start < seconds:
        pid, status = os.waitpid(child, os.WNOHANG)
        if pid:
            return status
        time.sleep(.01)
    os.kill(child, signal.SIGKILL)
    os.waitpid(child, 0)
    raise AssertionError("the child hangs")


def check_fork(device):
    """A forked child gets exceptions from devices, may trace paths, and ends as any, with handles of its parent."""
    scene = manylight.Scene(BOX)
    renderer = device.renderer(scene, SIZE)
    expected = renderer.render()["beauty"].tobytes()

    def refused(call):
        try:
            call()
        except manylight.DeviceError as error:
            return "forked" in str(error)
        return False

    def use():
        return (refused(lambda: manylight.Device(allow_software=True)) and refused(lambda: device.render(BOX, SIZE))
                and refused(lambda: device.info) and refused(renderer.render) and refused(renderer.display)
                and manylight.reference(scene, (4, 4), samples=1)["direct"].shape == (4, 4, 3))

    busy = threading.Thread(target=lambda: device.render(BOX, SIZE))
    busy.start()
    for ends in ("at once", "as a script", "after freeing")[:3 if LONG else 2]:
        child = os.fork()
        if child == 0:
            good = use()
            if ends == "after freeing":
                renderer.close()
                device.close()
            if ends == "at once":
                os._exit(0 if good else 1)
            raise SystemExit(0 if good else 1)
        assert ended(child) == 0, ends
    busy.join()
    assert renderer.render()["beauty"].tobytes() == expected


def resident():
    """Bytes of memory that the process has."""
    with open("/proc/self/statm", encoding="utf-8") as statm:
        return int(statm.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


def check_growth(device):
    """Pictures, scenes and failures leave nothing."""
    def work():
        device.render(BOX, SIZE)
        try:
            manylight.Scene("missing.glb")
        except manylight.SceneError:
            pass

    rounds = 8 if LONG else 3
    for _ in range(3 if LONG else 2):
        work()
    before = resident()
    for _ in range(rounds):
        work()
    grown = (resident() - before) / rounds
    print(f"    {grown / 1e3:.1f} kB grown per round")
    assert grown < (200e3 if LONG else 1e6)


def has_sanitizer():
    """AddressSanitizer keeps freed memory for a while."""
    with open("/proc/self/maps", encoding="utf-8") as maps:
        return "libasan" in maps.read()


def main():
    check_libraries()
    check_arrays_outlive()
    with manylight.Device(allow_software=True) as device:
        check_gil(device)
        check_threads(device)
        check_progress(device)
        check_fork(device)
        if not has_sanitizer():  # which takes more address space than there is memory
            check_growth(device)
            check_memory()
        check_interrupt(device)
    # A device that nobody closes does not disturb the end.
    globals()["left"] = manylight.Device(allow_software=True)
    print("    done")


if __name__ == "__main__":  # processes that are spawned read this file again
    main()
