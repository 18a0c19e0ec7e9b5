# SPDX-License-Identifier: GPL-3.0-or-later
"""A cook that dies at any moment, or runs out of disk, leaves the old file or none."""
import ctypes
import os
import pathlib
import random
import resource
import shutil
import signal
import struct
import subprocess
import tempfile
import time
import unittest

import program

KILLS = 200 if program.FULL else 20


class Kill(program.Case):
    def words(self, *more):
        return [program.PROGRAM, "cook", "preview", "--shell", str(self.shell), "--visual", str(self.visual), "-o",
                str(self.output), "-q", "--layout", "contiguous", "--keep-work", *more]

    def time_of_a_cook(self):
        start = time.monotonic()
        self.ok(subprocess.run(self.words(), capture_output=True, text=True))
        return time.monotonic() - start

    def kill_at(self, moment, *more):
        """Starts a cook, kills it at the moment, and tells whether it was still running."""
        process = subprocess.Popen(self.words(*more), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(moment)
        was_running = process.poll() is None
        process.send_signal(signal.SIGKILL)
        process.wait()
        return was_running

    def test_a_killed_cook_leaves_the_old_file_or_none_or_the_new_one_whole(self):
        took = self.time_of_a_cook()
        new = self.output.read_bytes()
        seed = random.randrange(1 << 30)
        numbers = random.Random(seed)
        killed = 0
        for i in range(KILLS):
            old = None if i % 2 else b"the old file"
            self.output.unlink(missing_ok=True)
            if old:
                self.output.write_bytes(old)
            # Half of the kills aim at the end, where the file is written.
            moment = took * (numbers.uniform(0, 1.1) if i % 4 < 2 else numbers.uniform(0.7, 1.05))
            killed += self.kill_at(moment, *(["--timeout", "600"] if i % 5 == 0 else []))
            time.sleep(0.01 if i % 5 == 0 else 0)
            found = self.output.read_bytes() if self.output.exists() else None
            self.assertIn(found, [old, new], f"seed {seed}, kill {i} after {moment} s")
        self.assertGreater(killed, KILLS // 4, "too few kills hit a running cook")
        self.ok(subprocess.run(self.words(), capture_output=True, text=True))
        self.assertEqual(self.output.read_bytes(), new)

    def test_the_end_of_a_limited_cook_s_parent_is_its_own_end(self):
        process = subprocess.Popen(self.words("--timeout", "600"), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        time.sleep(0.02)
        children = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text().split()
        process.send_signal(signal.SIGKILL)
        process.wait()
        deadline = time.monotonic() + 10
        while any(self.is_alive(child) for child in children) and time.monotonic() < deadline:
            time.sleep(0.01)
        self.assertFalse(any(self.is_alive(child) for child in children))

    @staticmethod
    def is_alive(process):
        try:
            return pathlib.Path(f"/proc/{process}/stat").read_text().split(")")[1].split()[0] != "Z"
        except (FileNotFoundError, ProcessLookupError):
            return False


class Leftovers(program.Case):
    def names_made_by(self, work):
        """Names that came up in the folder meanwhile, however short they stayed; renamed files do not count."""
        made, header = 0x100, struct.Struct("iIII")  # IN_CREATE; struct inotify_event without its name
        libc = ctypes.CDLL(None)
        watch = libc.inotify_init()
        self.addCleanup(os.close, watch)
        self.assertGreater(libc.inotify_add_watch(watch, os.fsencode(self.folder), made), 0)
        work()
        self.path("end").touch()
        names = []
        while "end" not in names:
            events = os.read(watch, 65536)
            while events:
                *_, length = header.unpack_from(events)
                names.append(events[header.size:header.size + length].rstrip(b"\0").decode())
                events = events[header.size + length:]
        return names[:names.index("end")]

    def test_what_a_cook_writes_before_the_output_is_what_these_tests_look_for(self):
        names = self.names_made_by(lambda: self.ok(self.cook()))
        self.assertTrue(names)
        self.assertEqual(self.leftovers(), [])
        for name in names:
            self.path(name).touch()
        self.assertEqual(sorted(self.leftovers()), sorted(names))


class Disk(program.Case):
    def limited_cook(self, size, output=None):
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))
        return self.cook(output=output, preexec_fn=limit)

    def test_a_file_size_limit_leaves_the_old_file(self):
        self.ok(self.cook())
        size = self.output.stat().st_size
        self.output.write_bytes(b"old")
        for limit in [0, 1, 512, size // 2, size - 1]:
            self.fails(self.limited_cook(limit), 2, "out.hdf")
            self.assertEqual(self.output.read_bytes(), b"old")
            self.assertEqual(self.leftovers(), [])
        self.ok(self.limited_cook(size))
        self.assertEqual(self.output.stat().st_size, size)

    def test_a_full_disk_leaves_the_old_file(self):
        disk = self.path("disk")
        disk.mkdir()
        mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", str(disk)], capture_output=True)
        if mounted.returncode != 0:
            self.skipTest("may not mount a tmpfs")
        self.addCleanup(subprocess.run, ["umount", "-l", str(disk)], capture_output=True)
        output = disk / "out.hdf"
        output.write_bytes(b"old")
        self.fails(self.cook(output=output), 2, "out.hdf")
        self.assertEqual(output.read_bytes(), b"old")
        self.assertEqual(os.listdir(disk), ["out.hdf"])

    def test_a_report_that_does_not_fit_does_not_harm_the_output(self):
        self.fails(self.cook("--report", "/dev/full"), 2)
        self.assertFalse(self.output.exists())

    @unittest.skipUnless(os.geteuid() == 0, "needs another user to be refused by a read-only folder")
    def test_a_read_only_folder_is_refused_before_any_work(self):
        outside = pathlib.Path(tempfile.mkdtemp(prefix="crumple_user_"))
        self.addCleanup(shutil.rmtree, outside, ignore_errors=True)
        shutil.copy(program.PROGRAM, outside / "crumple")
        shutil.copy(self.shell, outside / "shell.obj")
        os.chmod(outside, 0o755)
        folder = outside / "folder"
        folder.mkdir()
        os.chmod(folder, 0o555)
        nobody = 65534
        words = [outside / "crumple", "cook", "smoke", "--shell", outside / "shell.obj", "-o", folder / "out.hdf"]
        process = subprocess.run(list(map(str, words)), capture_output=True, text=True, user=nobody, group=nobody, cwd="/")
        self.fails(process, 2, "folder")
        self.assertEqual(os.listdir(folder), [])


if __name__ == "__main__":
    unittest.main()
