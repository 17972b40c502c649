"""Reads and writes a bucket by the client of Amazon: an independent view of what slipgap has done.

make BUCKET              makes a bucket
get BUCKET FOLDER        copies all objects into a folder
put BUCKET FOLDER        copies a folder into the bucket
unfinished BUCKET        prints the keys of uploads in pieces that have not ended
"""

import pathlib
import sys

import boto3

client = boto3.client("s3")
verb, bucket, *rest = sys.argv[1:]
if verb == "make":
    client.create_bucket(Bucket=bucket)
elif verb == "get":
    folder = pathlib.Path(rest[0])
    pages = client.get_paginator("list_objects_v2").paginate(Bucket=bucket)
    for own in (own for page in pages for own in page.get("Contents", [])):
        path = folder / own["Key"]
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(client.get_object(Bucket=bucket, Key=own["Key"])["Body"].read())
elif verb == "put":
    folder = pathlib.Path(rest[0])
    for path in (path for path in folder.rglob("*") if path.is_file()):
        client.put_object(Bucket=bucket, Key=str(path.relative_to(folder)), Body=path.read_bytes())
elif verb == "unfinished":
    for own in client.list_multipart_uploads(Bucket=bucket).get("Uploads", []):
        print(own["Key"])
