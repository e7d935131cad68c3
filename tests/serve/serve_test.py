"""The window as a browser sees it: hostile requests are refused, and a case is drawn, run and compared.

usage: tests/serve/serve_test.py PROGRAM
"""

import http.client
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

PROGRAM = sys.argv.pop(1)

CASE = {
    "keyblock": 2,
    "units": {"length": "m", "mass": "kg", "time": "s"},
    "blocks": {
        "blocks": [
            {"outer": [[0, -1, 1], [6, -1, 1], [6, 0, 1], [0, 0, 1]]},
            {"outer": [[1, 0, 1], [5, 0, 1], [5, 1, 1], [1, 1, 1]]},
        ],
        "fixed_points": [[0.5, -0.5, 1], [5.5, -0.5, 1]],
    },
    "analysis": {
        "step_count": 4, "time_step": 0.001, "gravity": 9.81,
        "block_materials": [{"density": 2500, "youngs_modulus": 5e9}],
        "joint_materials": [{"friction_angle_deg": 30}],
    },
}


class Server:
    """The program, serving a fresh folder."""

    def __init__(self):
        self.top = Path(tempfile.mkdtemp(prefix="keyblock_serve_test_"))
        self.folder = self.top / "served"
        self.folder.mkdir()
        (self.top / "secret.json").write_text("secret")
        (self.folder / "case.json").write_text(json.dumps(CASE))
        (self.folder / "bad.json").write_text('{"keyblock": 2,\n "blok": 3}')
        (self.folder / ".hidden.json").write_text("secret")
        os.symlink(self.top / "secret.json", self.folder / "link.json")
        self.process = subprocess.Popen([PROGRAM, "serve", str(self.folder)], stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE, text=True)
        address = self.process.stdout.readline().strip()
        self.port, self.token = re.fullmatch(r"http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{64})", address).groups()
        self.host = f"127.0.0.1:{self.port}"
        self.cookie = self.ask("GET", f"/?token={self.token}", cookie=None)[2]["Set-Cookie"].split(";")[0]

    def ask(self, method, target, body=None, cookie="own", **headers):
        connection = http.client.HTTPConnection("127.0.0.1", int(self.port), timeout=30)
        sent = {"Host": self.host}
        if cookie is not None:
            sent["Cookie"] = self.cookie if cookie == "own" else cookie
        if method == "POST":
            sent |= {"Origin": "http://" + self.host, "Content-Type": "application/json"}
        for name, value in headers.items():
            name = name.replace("_", "-")
            sent.pop(name, None)
            if value is not None:
                sent[name] = value
        if body is not None and not isinstance(body, (str, bytes)):
            body = json.dumps(body)
        connection.request(method, target, body, sent)
        reply = connection.getresponse()
        text = reply.read()
        connection.close()
        return reply.status, text, reply.headers

    def json(self, method, target, body=None):
        status, text, _ = self.ask(method, target, body)
        return status, json.loads(text)

    def wait_for(self, job):
        for _ in range(600):
            found = next(j for j in self.json("GET", "/api/jobs")[1]["jobs"] if j["id"] == job)
            if found["state"] in ("ended", "stopped"):
                return found
            time.sleep(0.05)
        raise AssertionError(found)

    def end(self, how=signal.SIGINT):
        self.process.send_signal(how)
        code = self.process.wait(timeout=30)
        self.process.stdout.close()
        self.process.stderr.close()
        shutil.rmtree(self.top)
        return code


class Followed:
    """A result folder whose frames a test puts in place one by one."""

    def __init__(self, server, name, last=1):
        if not (server.folder / "made").exists():
            job = server.json("POST", "/api/run", {"paths": ["case.json"], "result": "made", "record_every": 1})[1]["id"]
            server.wait_for(job)
        self.server, self.name, self.frames = server, name, server.folder / name / "frames"
        self.frames.mkdir(parents=True)
        for step in range(last + 1):
            self.put(step)

    def put(self, step, parts=("contacts_", "joints_", "")):
        for part in parts:
            ending = "vtp" if part else "vtu"
            made = self.server.folder / f"made/frames/{part}{min(step, 4):08}.{ending}"
            if made.exists():
                draft = self.frames / ".keyblock_draft_1_0"
                shutil.copy(made, draft)
                draft.rename(self.frames / f"{part}{step:08}.{ending}")

    def ask(self, after, stamp="", epoch=0, **headers):
        target = f"/api/live?result={self.name}&after={after}&epoch={epoch}&stamp={stamp}&running=0"
        status, text, _ = self.server.ask("GET", target, **headers)
        head, _, numbers = text.partition(b"\n")
        news = json.loads(head)
        assert len(numbers) == sum(news.get("sizes", {}).values()), "each chunk has its bytes"
        return status, news


class LiveTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()

    @classmethod
    def tearDownClass(cls):
        assert cls.server.end() == 0

    def test_the_newest_frame_comes_when_it_is_whole(self):
        run = Followed(self.server, "whole")
        stamp = run.ask(1)[1]["stamp"]
        with ThreadPoolExecutor(1) as client:
            begun = time.monotonic()
            asked = client.submit(run.ask, 1, stamp)
            time.sleep(0.3)
            run.put(2, ("contacts_", "joints_"))
            time.sleep(0.3)
            run.put(2, ("",))
            status, news = asked.result()
        self.assertGreater(time.monotonic() - begun, 0.6, "contacts alone are no frame")
        self.assertEqual((status, [f["step"] for f in news["frames"]], news["epochs"]), (200, [2], []))
        self.assertEqual(sorted(c["id"] for c in news["chunks"]), sorted(news["sizes"]))
        for step in (3, 4):
            run.put(step)
        self.assertEqual([f["step"] for f in run.ask(2, news["stamp"])[1]["frames"]], [4], "no queue")
        begun = time.monotonic()
        self.assertEqual(run.ask(4, run.ask(4)[1]["stamp"])[1], {"is_running": False})
        self.assertTrue(4 < time.monotonic() - begun < 9, "nothing new within five seconds")

    def test_a_frame_names_its_stage_and_kind_of_steps(self):
        server = self.server
        case = CASE | {"stages": [{"name": "weight", "steps": 2}, {"name": "excavation", "steps": 2}]}
        (server.folder / "staged.json").write_text(json.dumps(case))
        for motion, is_static in (("dynamic", False), ("static", True)):
            body = {"paths": ["staged.json"], "result": motion, "record_every": 1, "set": {"motion": motion}}
            self.assertEqual(server.wait_for(server.json("POST", "/api/run", body)[1]["id"])["exit_code"] in (0, 1), True)
            (server.folder / motion / "run.json").unlink()  # as it is while the run goes on
            head = json.loads(server.ask("GET", f"/api/live?result={motion}&after=0&epoch=0")[1].split(b"\n")[0])
            self.assertEqual([(f["stage"], f["is_static"]) for f in head["frames"]], [("excavation", is_static)])
            page = server.ask("GET", f"/page?result={motion}")[1].decode()
            frames = json.loads(re.search(r'id="keyblock-head">(.*?)</script>', page, re.S)[1])["frames"]
            self.assertEqual([f["stage"] for f in frames], ["weight"] * 3 + ["excavation"] * (len(frames) - 3))
            self.assertEqual({f["is_static"] for f in frames}, {is_static})

    def test_frames_that_were_replaced_are_told(self):
        run = Followed(self.server, "anew", 4)
        stamp = run.ask(4)[1]["stamp"]
        self.assertTrue(run.ask(7)[1]["is_anew"], "beyond the end")
        self.assertTrue(run.ask(4, stamp, epoch=9)[1]["is_anew"])
        with ThreadPoolExecutor(1) as client:
            asked = client.submit(run.ask, 4, stamp)
            time.sleep(0.3)
            (run.frames / "00000004.vtu").unlink()  # as a resumed run does with frames after its checkpoint
            self.assertTrue(asked.result()[1]["is_anew"])
        run.put(4)
        self.assertTrue(run.ask(4, stamp)[1]["is_anew"], "the same step, written again")

    def test_a_result_that_is_removed_is_told(self):
        run = Followed(self.server, "removed")
        stamp = run.ask(1)[1]["stamp"]
        with ThreadPoolExecutor(1) as client:
            asked = client.submit(run.ask, 1, stamp)
            time.sleep(0.3)
            with tempfile.TemporaryDirectory() as elsewhere:  # at once: half a result is another one
                run.frames.parent.rename(Path(elsewhere) / "removed")
            self.assertEqual(asked.result()[0], 404)
        self.assertEqual(run.ask(1, stamp)[0], 404)
        again = Followed(self.server, "removed")
        stamp = again.ask(1)[1]["stamp"]
        with ThreadPoolExecutor(1) as client:
            asked = client.submit(again.ask, 1, stamp)
            time.sleep(0.3)
            begun = time.monotonic()
            again.put(2)
            self.assertEqual(asked.result()[1]["frames"][0]["step"], 2)
        self.assertLess(time.monotonic() - begun, 2)

    def test_the_guards_hold(self):
        run = Followed(self.server, "guarded")
        self.assertEqual(run.ask(0, Origin="http://evil.example")[0], 403)
        self.assertEqual(run.ask(0, Host="evil.example")[0], 403)
        self.assertEqual(run.ask(0, cookie=None)[0], 403)
        for wrong in ("-1", "x", "", "1e3", "99999999999"):
            self.assertEqual(run.ask(wrong)[0], 400, wrong)
        outside = self.server.top / "outside"
        shutil.copytree(run.frames, outside)
        (self.server.folder / "linked").mkdir()
        os.symlink(outside, self.server.folder / "linked/frames")
        self.assertEqual(self.server.ask("GET", "/api/live?result=linked&after=0&epoch=0")[0], 404)
        (run.frames / "00000002.vtu").write_text("half a file")
        self.assertEqual(run.ask(1)[0], 422)

    def test_a_hundred_watch_at_once(self):
        run = Followed(self.server, "many")
        stamp = run.ask(1)[1]["stamp"]
        head = f"Host: {self.server.host}\r\nCookie: {self.server.cookie}\r\nConnection: close\r\n\r\n"
        clients = []
        for _ in range(100):
            client = socket.create_connection(("127.0.0.1", int(self.server.port)), timeout=30)
            target = f"/api/live?result=many&after=1&epoch=0&stamp={stamp}&running=0"
            client.sendall(f"GET {target} HTTP/1.1\r\n{head}".encode())
            clients.append(client)
        time.sleep(0.5)
        begun = time.monotonic()
        self.assertEqual(self.server.ask("GET", "/api/list")[0], 200)
        self.assertLess(time.monotonic() - begun, 2, "others are answered meanwhile")
        run.put(2)
        begun = time.monotonic()
        replies = []
        for client in clients:
            with client.makefile("rb") as stream:
                replies.append(stream.read())
            client.close()
        self.assertLess(time.monotonic() - begun, 2)
        self.assertTrue(all(b'"step":2' in reply for reply in replies))


class ServeTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.server = Server()

    @classmethod
    def tearDownClass(cls):
        assert cls.server.end() == 0, "Ctrl-C ends it cleanly"

    def test_only_the_printed_address_lets_in(self):
        ask = self.server.ask
        self.assertEqual(ask("GET", "/", cookie=None)[0], 403)
        self.assertEqual(ask("GET", "/?token=" + "0" * 64, cookie=None)[0], 403)
        self.assertEqual(ask("GET", "/api/list", cookie="keyblock=1")[0], 403)
        self.assertEqual(ask("GET", "/api/list?token=" + self.server.token, cookie=None)[0], 403)
        status, _, headers = ask("GET", "/?token=" + self.server.token, cookie=None)
        self.assertEqual((status, headers["Location"]), (303, "/"))
        for word in ("HttpOnly", "SameSite=Strict"):
            self.assertIn(word, headers["Set-Cookie"])
        self.assertNotIn(self.server.token, headers["Set-Cookie"])
        status, page, headers = ask("GET", "/")
        self.assertEqual(status, 200)
        self.assertIn("default-src 'none'", headers["Content-Security-Policy"])

    def test_foreign_pages_and_hosts_are_refused(self):
        ask = self.server.ask
        for host in ("evil.example", "evil.example:" + self.server.port, "127.0.0.1", "127.0.0.1:1", ""):
            self.assertEqual(ask("GET", "/api/list", Host=host)[0], 403, host)
        for origin in ("http://evil.example", "null", "https://" + self.server.host, "http://127.0.0.1:1"):
            self.assertEqual(ask("GET", "/api/list", Origin=origin)[0], 403, origin)
            self.assertEqual(ask("POST", "/api/save", {"path": "x.json", "text": ""}, Origin=origin)[0], 403, origin)
        self.assertEqual(ask("POST", "/api/save", {"path": "x.json", "text": ""}, Origin=None)[0], 403)
        self.assertEqual(ask("POST", "/api/save", {"path": "x.json", "text": ""}, Content_Type="text/plain")[0], 415)
        self.assertEqual(ask("PUT", "/api/save", {"path": "x.json", "text": ""})[0], 405)
        self.assertFalse((self.server.folder / "x.json").exists())

    def test_no_path_leads_out(self):
        secrets = ["../secret.json", "/etc/passwd", str(self.server.top / "secret.json"), "a/../../secret.json",
                   "..%2fsecret.json", "%2e%2e/secret.json", "link.json", ".hidden.json", "./.hidden.json", "",
                   "case.json%00.svg", "....//secret.json", "case.json/../../secret.json"]
        for path in secrets:
            for target in ("/api/read?path=", "/api/drawing?path=", "/api/thumbnail?path=", "/page?result=", "/report?result=", "/api/record?result=",
                           "/api/live?after=0&epoch=0&result="):
                status, text, _ = self.server.ask("GET", target + path)
                self.assertIn(status, (400, 404), target + path)
                self.assertNotIn(b"secret\"", text)
            for target, body in (("/api/save", {"path": path, "text": "x", "overwrite": True}),
                                 ("/api/check", {"paths": [path]}), ("/api/run", {"paths": [path], "result": "r"}),
                                 ("/api/run", {"paths": ["case.json"], "result": path}),
                                 ("/api/convert", {"paths": ["case.json"], "target": path})):
                path_as_text = path.replace("%2f", "/").replace("%2e", ".").replace("%00", "\0")
                body = json.loads(json.dumps(body).replace(json.dumps(path), json.dumps(path_as_text)))
                self.assertIn(self.server.ask("POST", target, body)[0], (400, 404), target + path)
        self.assertEqual((self.server.top / "secret.json").read_text(), "secret")
        self.assertEqual((self.server.folder / ".hidden.json").read_text(), "secret")
        names = [f["path"] for f in self.server.json("GET", "/api/list")[1]["files"]]
        self.assertEqual([n for n in names if n.startswith((".", "link"))], [])
        for name in ("../secret.json", "link.json"):
            settings = {"paths": ["case.json"], "set": {"body_acceleration_file": name}}
            self.assertEqual(self.server.ask("POST", "/api/check", settings)[0], 404, name)
            for key in ("body_acceleration_file", "/run/set/body_acceleration_file", "/drawing"):
                sweep = {"paths": ["case.json"], "result": "no", "over": [f"{key}={name}"]}
                self.assertEqual(self.server.ask("POST", "/api/sweep", sweep)[0], 404, sweep)

    def test_a_case_names_no_file_outside(self):
        server = self.server
        outside = server.top / "outside.json"
        outside.write_text(json.dumps({"keyblock": 2, "blocks": CASE["blocks"]}))
        table = server.top / "quake.txt"
        table.write_text("0 0 0\n1 0 0\n")
        os.symlink(outside, server.folder / "to_outside.json")
        (server.folder / "inside.json").write_text(outside.read_text())
        rest = {"keyblock": 2, "analysis": CASE["analysis"]}
        for name in ("../outside.json", str(outside), "to_outside.json"):
            case = json.dumps({**rest, "drawing": name})
            (server.folder / "names.json").write_text(case)
            for body in ({"paths": ["names.json"]}, {"path": "names.json", "text": case}):
                report = server.json("POST", "/api/check", body)[1]
                self.assertEqual(report["exit_code"], 3, (name, report))
                self.assertTrue(any(word in report["errors"][0]["sentence"] for word in ("within the served", "no file")))
            self.assertEqual(server.ask("GET", "/api/drawing?path=names.json")[0], 422)
            job = server.json("POST", "/api/run", {"paths": ["names.json"], "result": "names"})[1]["id"]
            self.assertEqual(server.wait_for(job)["exit_code"], 3)
        for name, code in (("../quake.txt", 3), (str(table), 3)):
            case = {**CASE, "run": {"set": {"body_acceleration_file": name}}}
            (server.folder / "shaken.json").write_text(json.dumps(case))
            self.assertEqual(server.json("POST", "/api/check", {"paths": ["shaken.json"]})[1]["exit_code"], code)
        (server.folder / "names.json").write_text(json.dumps({**rest, "drawing": "inside.json"}))
        self.assertEqual(server.json("POST", "/api/check", {"paths": ["names.json"]})[1]["errors"], [])
        for file in (outside, table):
            file.unlink()

    def test_units_with_a_slash_are_no_paths(self):
        report = self.server.json("POST", "/api/check", {"paths": ["case.json"], "set": {"gravity": "9.5 m/s2"}})[1]
        self.assertEqual((report["errors"], report["case"]["settings"]["gravity.y"]), ([], -9.5))
        body = {"paths": ["case.json"], "result": "slashes", "over": ["gravity=9,9.5 m/s2"]}
        job = self.server.json("POST", "/api/sweep", body)[1]["id"]
        self.assertEqual(self.server.wait_for(job)["exit_code"], 0)

    def test_bad_bodies_are_refused(self):
        for body in ("", "{", "[]", "3", '"x"', "{}", '{"path": 3}', '{"path": "a", "text": null}', "[" * 100000,
                     '{"paths": "case.json"}', b"\xff\xfe\x00"):
            for target in ("/api/save", "/api/check", "/api/run", "/api/stop"):
                self.assertIn(self.server.ask("POST", target, body)[0], (400, 404), body[:20])
        for option in ("--force", "-o", "a b", "../x"):
            body = {"paths": ["case.json"], "profile": option}
            self.assertEqual(self.server.ask("POST", "/api/check", body)[0], 400, option)
            body = {"paths": ["case.json"], "set": {option: "1"}}
            self.assertEqual(self.server.ask("POST", "/api/check", body)[0], 400, option)

    def test_what_is_no_http_or_too_long_is_refused(self):
        def send(data):
            with socket.create_connection(("127.0.0.1", int(self.server.port)), timeout=10) as client:
                try:
                    client.sendall(data)
                    return client.recv(4096)
                except ConnectionError:
                    return b""
        head = f"Host: {self.server.host}\r\nCookie: {self.server.cookie}\r\n".encode()
        post = head + f"Origin: http://{self.server.host}\r\nContent-Type: application/json\r\n".encode()
        self.assertIn(b" 400 ", send(b"\x16\x03\x01 nonsense\r\n\r\n")[:20])
        self.assertNotIn(b" 200 ", send(b"GET / HTTP/1.1\r\n" + head + b"X: " + b"y" * 100000 + b"\r\n\r\n")[:20])
        long = b"POST /api/save HTTP/1.1\r\n" + post + b"Content-Length: 99999999999\r\n\r\n"
        self.assertIn(b" 413 ", send(long)[:20])
        twice = b"GET /api/list HTTP/1.1\r\n" + head + b"Host: evil.example\r\n\r\n"
        self.assertIn(b" 400 ", send(twice)[:20])
        unseen = b"POST /api/save HTTP/1.1\r\nHost: x\r\nContent-Length: 99999999999\r\n\r\n"
        self.assertIn(send(unseen)[9:12], (b"403",), "refused before the body is read")

    def test_a_hundred_at_once_do_not_stop_it(self):
        clients = []
        for _ in range(100):
            client = socket.create_connection(("127.0.0.1", int(self.server.port)), timeout=10)
            client.sendall(b"GET / HTTP/1.1\r\n")  # and no more
            clients.append(client)
        begun = time.monotonic()
        self.assertEqual(self.server.ask("GET", "/api/list")[0], 200, "beside a hundred silent connections")
        self.assertLess(time.monotonic() - begun, 2)
        try:
            self.assertEqual(clients[0].recv(100), b"", "the oldest is closed")
        except ConnectionError:
            pass
        for client in clients:
            client.close()

    def test_members_of_a_wrong_kind_start_nothing(self):
        run = {"paths": ["case.json"], "result": "wrong"}
        for target, more in (("/api/run", {"histories": ["crest=punkt:1,2"]}), ("/api/run", {"histories": "point:1,2"}),
                             ("/api/run", {"record_every": "3"}), ("/api/run", {"record_every": 0}),
                             ("/api/fos", {"reduce": "blocks"}), ("/api/fos", {"reduce": 3}),
                             ("/api/check", {"trial": "yes"}), ("/api/check", {"trial": 1})):
            status, reply = self.server.json("POST", target, {**run, **more})
            self.assertEqual(status, 400, (target, more))
            self.assertNotIn("--", reply["error"])
        wrong_sum = {"path": "k.json", "text": "", "sha256": 3}
        self.assertEqual(self.server.ask("POST", "/api/save", wrong_sum)[0], 400)
        self.assertFalse((self.server.folder / "k.json").exists())
        self.assertEqual([j for j in self.server.json("GET", "/api/jobs")[1]["jobs"] if j["result"] == "wrong"], [])

    def test_sentences_name_no_options(self):
        for settings in ({"steps": "many"}, {"stepz": "3"}):
            report = self.server.json("POST", "/api/check", {"paths": ["case.json"], "set": settings})[1]
            self.assertTrue(report["errors"])
            self.assertNotIn("--", json.dumps(report["errors"]))

    def test_errors_have_line_and_column(self):
        status, report = self.server.json("POST", "/api/check", {"paths": ["bad.json"]})
        self.assertEqual((status, report["exit_code"]), (200, 3))
        error = report["errors"][0]
        self.assertEqual((error["file"], error["line"], error["column"]), ("bad.json", 2, 2))
        self.assertIn('found "blok"', error["sentence"])

    def test_saving_replaces_only_the_file_that_was_read(self):
        save = lambda **body: self.server.json("POST", "/api/save", {"path": "saved.json", **body})
        status, first = save(text="one\n")
        self.assertEqual(status, 200)
        status, refused = save(text="two\n")
        self.assertEqual((status, refused["error"]), (409, "saved.json exists already"))
        self.assertEqual(save(text="two\n", overwrite=True)[0], 409, "nobody has read the file")
        status, read = self.server.json("GET", "/api/read?path=saved.json")
        self.assertEqual((read["text"], read["sha256"]), ("one\n", first["sha256"]))
        (self.server.folder / "saved.json").write_text("changed by another program\n")
        self.assertEqual(save(text="two\n", sha256=first["sha256"])[0], 409)
        self.assertEqual((self.server.folder / "saved.json").read_text(), "changed by another program\n")
        now = self.server.json("GET", "/api/read?path=saved.json")[1]["sha256"]
        with ThreadPoolExecutor(8) as clients:
            replies = list(clients.map(lambda i: save(text=f"edit {i}\n", sha256=now)[0], range(8)))
        self.assertEqual(sorted(replies), [200] + 7 * [409], "one of equal edits wins, the others learn of it")
        self.assertEqual((self.server.folder / "saved.json").read_text(), f"edit {replies.index(200)}\n")

    def test_equal_requests_start_one_job(self):
        # The server copies the inputs between the check and the start of a job: a long file takes its time.
        (self.server.folder / "padded.json").write_text("// " + 12_000_000 * "x" + "\n" + json.dumps(CASE))
        body = {"paths": ["padded.json"], "result": "once", "set": {"steps": "2000"}}
        with ThreadPoolExecutor(8) as clients:
            replies = list(clients.map(lambda _: self.server.json("POST", "/api/run", body), range(8)))
        self.assertEqual(sorted(status for status, _ in replies), [200] + 7 * [409])
        self.assertNotIn(str(self.server.top), json.dumps(replies))
        job = next(reply["id"] for status, reply in replies if status == 200)
        self.assertEqual(self.server.wait_for(job)["exit_code"], 0)

    def test_a_case_goes_the_whole_way(self):
        server = self.server
        status, report = server.json("POST", "/api/check", {"paths": ["case.json"], "trial": True})
        self.assertEqual((status, report["errors"]), (200, []))
        self.assertIn("cost", report["case"])
        for target in ("/api/drawing?path=case.json", "/api/thumbnail?path=case.json"):
            status, svg, headers = server.ask("GET", target)
            self.assertEqual((status, headers["Content-Type"]), (200, "image/svg+xml"))
            self.assertIn(b"<path", svg)
        self.assertEqual(server.json("POST", "/api/save", {"path": "own.json", "text": json.dumps(CASE)})[0], 200)
        jobs = []
        for result, steps in (("a", "4"), ("b", "6")):
            status, started = server.json("POST", "/api/run",
                                          {"paths": ["own.json"], "result": result, "set": {"steps": steps}})
            self.assertEqual(status, 200, started)
            jobs.append(started["id"])
        self.assertEqual(server.ask("POST", "/api/run", {"paths": ["own.json"], "result": "a"})[0], 409)
        for job in jobs:
            ended = server.wait_for(job)
            self.assertEqual(ended["exit_code"], 0, ended)
        self.assertEqual(server.json("GET", "/api/record?result=b")[1]["outcome"]["steps"], 6)
        differences = server.json("GET", "/api/compare?first=a&second=b")[1]["differences"]
        steps = next(d for d in differences if d["path"] == "settings.steps")
        self.assertEqual((steps["first"], steps["second"]), (4, 6))
        status, page, headers = server.ask("GET", "/report?result=a")
        self.assertEqual(status, 200)
        self.assertIn(b"Checksums", page)
        status, page, headers = server.ask("GET", "/page?result=a")
        self.assertEqual(status, 200)
        self.assertIn(b'id="keyblock-head"', page)
        self.assertIn("text/html", headers["Content-Type"])
        status, svg, headers = server.ask("GET", "/api/picture?result=a")
        self.assertIn(b"<svg", svg)
        self.assertIn("sandbox", headers["Content-Security-Policy"])
        (server.folder / "a/picture.svg").unlink()
        self.assertIn(b"<svg", server.ask("GET", "/api/picture?result=a")[1], "drawn from the last frame")
        results = [r["path"] for r in server.json("GET", "/api/list")[1]["results"]]
        self.assertTrue({"a", "b"} <= set(results), results)

    def test_a_folder_that_is_missing_is_named(self):
        body = {"paths": ["case.json"], "result": "none/here/run"}
        self.assertEqual(self.server.json("POST", "/api/run", body), (404, {"error": "there is no folder none/here"}))

    def test_a_name_that_is_too_long_is_said_to_be_so(self):
        status, reply = self.server.json("GET", "/api/read?path=" + 256 * "x")
        self.assertEqual((status, reply["error"]), (404, "no file can have this path: File name too long"))

    def test_names_that_are_not_utf8_are_counted(self):
        odd = os.fsencode(self.server.folder) + b"/bad\xff\xfe.json"
        Path(os.fsdecode(odd)).write_text("{}")
        listing = self.server.json("GET", "/api/list")[1]
        os.remove(odd)
        self.assertEqual([f["path"] for f in listing["files"] if f["path"].startswith("bad")], ["bad.json"])
        self.assertEqual(listing["unreadable"], 1)

    def test_notes_on_a_case_are_no_case(self):
        folder = self.server.folder / "verification"
        folder.mkdir()
        (folder / "case.json").write_text('{"about": "a block at rest", "legacy": "not run: too slow"}')
        (folder / "wrong.json").write_text('{"about": "no case"}')
        paths = [file["path"] for file in self.server.json("GET", "/api/list")[1]["files"]]
        self.assertIn("case.json", paths)
        self.assertIn("verification/wrong.json", paths)
        self.assertNotIn("verification/case.json", paths)

    def test_changed_inputs_are_listed(self):
        server = self.server
        (server.folder / "changed.json").write_text(json.dumps(CASE))
        server.wait_for(server.json("POST", "/api/run", {"paths": ["changed.json"], "result": "before"})[1]["id"])
        changed = json.loads(json.dumps(CASE))
        changed["analysis"]["joint_materials"][0]["friction_angle_deg"] = 35
        (server.folder / "changed.json").write_text("// a comment\n" + json.dumps(changed))
        server.wait_for(server.json("POST", "/api/run", {"paths": ["changed.json"], "result": "after"})[1]["id"])
        reply = server.json("GET", "/api/compare?first=before&second=after")[1]
        self.assertEqual([(d["path"], d["first"], d["second"]) for d in reply["inputs"]],
                         [("analysis.joint_materials[1].friction_angle_deg", 30, 35)])

    def test_studies_have_results(self):
        server = self.server
        over = ["/analysis/joint_materials/0/friction_angle_deg=20,30"]
        job = server.json("POST", "/api/sweep", {"paths": ["case.json"], "result": "sw", "over": over,
                                                 "out": ["displacement"]})[1]["id"]
        self.assertEqual(server.wait_for(job)["exit_code"], 0)
        entry = next(r for r in server.json("GET", "/api/list")[1]["results"] if r["path"] == "sw")
        self.assertEqual((entry["kind"], entry["is_finished"]), ("sweep", True))
        self.assertEqual(len(server.json("GET", "/api/read?path=sw/table.csv")[1]["text"].splitlines()), 3)
        search = server.wait_for(server.json("POST", "/api/fos", {"paths": ["case.json"], "result": "fs"})[1]["id"])
        self.assertTrue("stands" in search or "falls" in search, search)
        self.assertIn("factor_of_safety", server.json("GET", "/api/record?result=fs")[1])
        for bad in ([], ["x"], ["=3"], "a=1", [3], ["/analysis/gravity="]):
            self.assertEqual(server.ask("POST", "/api/sweep", {"paths": ["case.json"], "result": "no", "over": bad})[0], 400)
        test = {"path": "case.json", "kind": "uniaxial", "to": [-0.001]}
        status, reply = server.json("POST", "/api/element", test)
        self.assertEqual((status, reply["exit_code"]), (200, 0), reply["messages"])
        self.assertIn("<svg", reply["svg"])
        self.assertLess(reply["record"]["least_stress"], 0)
        self.assertEqual(reply["record"]["units"], {"stress": "Pa"})
        for more in ({"kind": "--force"}, {"to": []}, {"to": ["-0.001"]}, {"material": 0}, {"confining": "5"}):
            self.assertEqual(server.ask("POST", "/api/element", {**test, **more})[0], 400, more)
        (server.folder / "tests.csv").write_text("s3 [MPa],s1 [MPa]\n" + "".join(f"{x},{10 + 4 * x}\n" for x in (0, 2, 4, 6)))
        status, reply = server.json("POST", "/api/fit", {"path": "tests.csv", "kind": "triaxial"})
        self.assertEqual((status, reply["exit_code"]), (200, 0), reply["messages"])
        self.assertIn("<svg", reply["svg"])
        self.assertEqual(reply["record"]["parameters"]["cohesion"]["unit"], "MPa")
        self.assertEqual(server.ask("POST", "/api/fit", {"path": "tests.csv", "kind": "other"})[0], 400)

    def test_a_run_by_both_profiles_has_two_results(self):
        body = {"paths": ["case.json"], "result": "two", "both": True}
        self.server.wait_for(self.server.json("POST", "/api/run", body)[1]["id"])
        results = [r["path"] for r in self.server.json("GET", "/api/list")[1]["results"]]
        self.assertTrue({"two/legacy", "two/standard"} <= set(results), results)
        for more in ({"profile": "legacy"}, {"stop_when": "a.d>1"}, {"both": "yes"}):
            self.assertEqual(self.server.ask("POST", "/api/run", {**body, "result": "no", **more})[0], 400, more)
        self.assertEqual(self.server.ask("POST", "/api/run", {"paths": ["case.json"], "result": "no", "stop_when": "a"})[0], 400)

    def test_unsaved_text_is_cut_and_checked(self):
        ask = lambda target, **body: self.server.json("POST", target, body)
        rows = [[0, 0, 4, 0, 1], [4, 0, 4, 2, 1], [4, 2, 0, 2, 1], [0, 2, 0, 0, 1], [2, -1, 2, 3, 1]]
        case = {**CASE, "drawing": {"boundary_count": 4, "joints": rows, "fixed_lines": [[-1, 0.01, 5, 0.01]]}}
        del case["blocks"]
        status, cut = ask("/api/blocks", path="not there.json", text=json.dumps(case))
        self.assertEqual((status, len(cut["blocks"])), (200, 2))
        self.assertEqual(cut["blocks"][0]["material"], 1)
        area = lambda loop: sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(loop, loop[1:] + loop[:1])) / 2
        self.assertAlmostEqual(sum(area(block["loops"][0]) for block in cut["blocks"]), 8)
        self.assertEqual(len(ask("/api/blocks", path="a.json", text=json.dumps(CASE))[1]["blocks"]), 2)
        status, bad = ask("/api/blocks", path="a.json", text='{"keyblock": 2,\n "blok": 3}')
        self.assertEqual((status, bad["errors"][0]["line"], bad["errors"][0]["file"]), (200, 2, "a.json"))
        status, report = ask("/api/check", path="a.json", text='{"keyblock": 2,\n "blok": 3}')
        self.assertEqual((status, report["exit_code"], report["errors"][0]["file"]), (200, 3, "a.json"))
        report = ask("/api/check", path='q"\\.json', text=json.dumps(case), set={"steps": "7"})[1]
        self.assertEqual((report["exit_code"], report["errors"]), (0, []))
        self.assertEqual(report["case"]["settings"]["steps"], 7)
        self.assertEqual(report["files"][0]["file"], 'q"\\.json')
        self.assertEqual(ask("/api/check", path="a.json", text="{}", set={"--force": "1"})[0], 400)
        for path in ("a.json", "a.yaml", "a.xml", "a.dxf", "a.geo", "a.blk", "a.cv"):
            for text in ("[" * 100000, '{"a":' * 100000, "<a>" * 100000, "9" * 100000, "\0" * 1000, "- " * 10000):
                status, reply = ask("/api/blocks", path=path, text=text)
                self.assertEqual((status, "blocks" in reply and bool(reply["blocks"])), (200, False), (path, text[:5]))
        for body in ({}, {"path": "a.json"}, {"path": 1, "text": ""}, {"path": "a.json", "text": 3}):
            self.assertEqual(ask("/api/blocks", **body)[0], 400, body)
        for path in ("../../x.json", "/etc/x", "", "a.j/../../son", "a.j\0son"):
            self.assertEqual(ask("/api/blocks", path=path, text="{}")[0], 200, path)
        self.assertEqual([n for n in os.listdir(self.server.top) if n not in ("served", "secret.json")], [])

    def test_joint_sets_fill_an_outline(self):
        ask = lambda spec: self.server.json("POST", "/api/joints", {"spec": spec})
        status, drawn = ask({"outline": [[0, 0], [0, 10], [10, 10], [10, 0]], "sets": [{"dip": 0, "spacing": 2}]})
        self.assertEqual((status, drawn["boundary_count"]), (200, 4))
        joints = drawn["joints"][4:]
        self.assertEqual(len(joints), 5)
        self.assertTrue(all(0 <= x <= 10 for row in joints for x in row[:4]), joints)
        status, bad = ask({"outline": [[0, 0], [1, 1]]})
        self.assertEqual(status, 200)
        self.assertIn("expected an outline of three or more corners", bad["errors"][0]["sentence"])
        self.assertEqual(ask(3)[0], 400)
        library = self.server.json("GET", "/api/materials")[1]
        self.assertIn("limestone", [rock["like"] for rock in library["block_materials"]])

    def test_a_run_is_stopped_and_resumed(self):
        server = self.server
        more = {"paths": ["case.json"], "set": {"steps": "20000"}, "record_every": 1000}
        job = server.json("POST", "/api/run", {**more, "result": "long"})[1]["id"]
        waiting = server.json("POST", "/api/run", {**more, "result": "never"})[1]["id"]
        for _ in range(200):
            if (server.folder / "long/frames/00001000.vtu").exists():
                break
            time.sleep(0.02)
        server.json("POST", "/api/stop", {"id": waiting})
        server.json("POST", "/api/stop", {"id": job})
        self.assertEqual(server.wait_for(job)["state"], "stopped")
        self.assertEqual(server.wait_for(waiting)["state"], "stopped")
        self.assertFalse((server.folder / "never").exists())
        self.assertEqual(server.json("GET", "/api/record?result=long")[1]["outcome"]["end"], "stopped")
        job = server.json("POST", "/api/resume", {"result": "long"})[1]["id"]
        self.assertEqual(server.ask("POST", "/api/resume", {"result": "long"})[0], 409, "it runs already")
        own = [j for j in server.json("GET", "/api/jobs")[1]["jobs"] if j["result"] == "long"]
        self.assertEqual([(j["id"], j["title"]) for j in own], [(job, "case.json")], "one job with its title")
        server.json("POST", "/api/stop", {"id": job})
        server.wait_for(job)


def children_of(process):
    return [int(child) for task in Path(f"/proc/{process}/task").iterdir()
            for child in (task / "children").read_text().split()]


class EndOfServerTest(unittest.TestCase):
    def test_drafts_of_a_killed_server_are_removed_at_the_next_start(self):
        temporary = Path(tempfile.gettempdir())
        before = set(temporary.glob("keyblock-serve-*"))
        killed = Server()
        (left,) = set(temporary.glob("keyblock-serve-*")) - before
        killed.end(signal.SIGKILL)
        living = Server()
        (own,) = set(temporary.glob("keyblock-serve-*")) - before - {left}
        foreign = temporary / "keyblock-serve-link"
        foreign.symlink_to(living.folder)
        for folder in (left, own):
            os.utime(folder, (0, 0))
        Server().end()
        self.assertEqual([left.exists(), own.exists(), living.folder.exists()], [False, True, True])
        foreign.unlink()
        living.end()
        self.assertFalse(own.exists())

    def test_a_killed_command_leaves_no_drafts(self):
        server = Server()
        rows = ",".join(f"[0, {i}, 1, {i}, 1]" for i in range(400_000))
        (server.folder / "long.json").write_text('{"keyblock": 2, "drawing": {"joints": [' + rows + "]}}")
        body = {"paths": ["long.json"], "target": "long.dxf"}
        with ThreadPoolExecutor(1) as client:
            asked = client.submit(server.ask, "POST", "/api/convert", body)
            while not (started := children_of(server.process.pid)):
                time.sleep(0.01)
            own, foreign = (server.folder / f".keyblock_draft_{process}_0" for process in (started[0], 1))
            for draft in (own, foreign):
                draft.write_text("half a file")
            server.process.send_signal(signal.SIGINT)
            server.process.wait(timeout=30)
            self.assertIsNotNone(asked.exception(), "the command was still at work")
        self.assertEqual([own.exists(), foreign.exists(), (server.folder / "long.dxf").exists()], [False, True, False])
        server.process.stdout.close()
        server.process.stderr.close()
        shutil.rmtree(server.top)

    def test_a_server_that_ends_leaves_whole_runs(self):
        for how in (signal.SIGTERM, signal.SIGKILL):
            server = Server()
            server.json("POST", "/api/run", {"paths": ["case.json"], "result": "r", "set": {"steps": "50000"},
                                             "record_every": 500})
            record = server.folder / "r/run.json"
            for _ in range(200):
                if (server.folder / "r/frames/00000500.vtu").exists():
                    break
                time.sleep(0.02)
            server.process.send_signal(how)
            server.process.wait(timeout=30)
            for _ in range(200):
                if record.exists():
                    break
                time.sleep(0.05)
            self.assertEqual(json.loads(record.read_text())["outcome"]["end"], "stopped")
            self.assertEqual(server.process.returncode, 0 if how == signal.SIGTERM else -signal.SIGKILL)
            server.process.stdout.close()
            server.process.stderr.close()
            shutil.rmtree(server.top)


if __name__ == "__main__":
    unittest.main()
