"""An S3 server (moto) on free ports of this machine, printed in one line: one that works, one that fails often, one that answers with a
page, one that does not keep parts, one that does not give them, and one that never answers. It keeps all objects in memory, and ends
with its standard input."""

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


servers = [make_server("127.0.0.1", 0, own, threaded=True) for own in (application, failing, page, forgetful, ungiving)]
for server in servers:
    threading.Thread(target=server.serve_forever, daemon=True).start()
silent = socket.create_server(("127.0.0.1", 0))
ports = [server.port for server in servers] + [silent.getsockname()[1]]
print(*ports, flush=True)
sys.stdin.read()
