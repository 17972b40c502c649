"""An S3 server (moto) on free ports of this machine, printed in one line: one that works, one that fails often, one that answers with a
page, one that does not keep parts, one that does not give them, one that gives a page for them, one whose lists have no end, one on
which another run removes parts, and one that never answers. It keeps all objects in memory, and ends with its standard input."""

import itertools
import logging
import socket
import sys
import threading

from moto.server import DomainDispatcherApplication, create_backend_app
from werkzeug.serving import make_server

logging.getLogger("werkzeug").setLevel(logging.ERROR)
application = DomainDispatcherApplication(create_backend_app)
requests = itertools.count(1)
counting = threading.Lock()


def failing(environ, start_response):
    """Of seven requests one is refused for a moment, and of one the connection breaks after a part of its content."""
    with counting:
        number = next(requests) % 7
    if number == 2:
        start_response("503 Slow Down", [("Content-Type", "application/xml")])
        return [b"<Error><Code>SlowDown</Code><Message>Reduce your request rate.</Message></Error>"]
    if number == 5:
        environ["wsgi.input"].read(int(environ.get("CONTENT_LENGTH") or 0) // 2)
        environ["werkzeug.socket"].shutdown(socket.SHUT_RDWR)
        start_response("200 OK", [])
        return [b"not sent"]
    return application(environ, start_response)


def page(environ, start_response):
    """A network that wants a password."""
    environ["wsgi.input"].read(int(environ.get("CONTENT_LENGTH") or 0))
    start_response("200 OK", [("Content-Type", "text/html")])
    return [b"<html><body>Please log in<br></body></html>"]


def is_of_part(environ, method):
    return environ["REQUEST_METHOD"] == method and environ["PATH_INFO"].endswith(".parquet")


def forgetful(environ, start_response):
    """Parts are received, and not kept."""
    if not is_of_part(environ, "PUT"):
        return application(environ, start_response)
    environ["wsgi.input"].read(int(environ.get("CONTENT_LENGTH") or 0))
    start_response("200 OK", [("ETag", '"0"')])
    return [b""]


def ungiving(environ, start_response):
    """Parts are listed, and not given."""
    if not is_of_part(environ, "GET"):
        return application(environ, start_response)
    start_response("500 Internal Server Error", [("Content-Type", "application/xml")])
    return [b"<Error><Code>InternalError</Code><Message>Try again.</Message></Error>"]


def paging(environ, start_response):
    """Parts are listed, and a page is given for them, of which a cache says what it says of files."""
    if not is_of_part(environ, "GET"):
        return application(environ, start_response)
    body = b"\n<html><body>Please log in<br></body></html>"
    date = "Thu, 01 Jan 2026 00:00:00 GMT"
    start_response("200 OK", [("ETag", '"0"'), ("Last-Modified", date), ("Content-Length", str(len(body)))])
    return [body]


def repeating(environ, start_response):
    """Each list has one part, and more to come."""
    if environ["REQUEST_METHOD"] != "GET" or "list-type" not in environ["QUERY_STRING"]:
        return application(environ, start_response)
    key = f"s/store/part-{0:012}-{0:032}.parquet"
    start_response("200 OK", [("Content-Type", "application/xml")])
    entry = f'<Key>{key}</Key><LastModified>2026-01-01T00:00:00.000Z</LastModified><ETag>"0"</ETag><Size>1</Size>'
    more = f"<IsTruncated>true</IsTruncated><NextContinuationToken>{next(requests)}</NextContinuationToken>"
    return [f"<ListBucketResult>{more}<Contents>{entry}</Contents></ListBucketResult>".encode()]


received = []


def robbing(environ, start_response):
    """Whoever removes a part here loses those that this port has received: another run removes them at the same time."""
    if is_of_part(environ, "PUT"):
        received.append(environ["PATH_INFO"])
    while is_of_part(environ, "DELETE") and received:
        path = received.pop()
        list(application({**environ, "PATH_INFO": path, "RAW_URI": path, "REQUEST_URI": path}, lambda *_: None))
    return application(environ, start_response)


applications = application, failing, page, forgetful, ungiving, paging, repeating, robbing
servers = [make_server("127.0.0.1", 0, own, threaded=True) for own in applications]
for server in servers:
    threading.Thread(target=server.serve_forever, daemon=True).start()
silent = socket.create_server(("127.0.0.1", 0))
ports = [server.port for server in servers] + [silent.getsockname()[1]]
print(*ports, flush=True)
sys.stdin.read()
