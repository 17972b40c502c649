// The shards of a study as tasks of Nextflow, then the merge:
//   nextflow run main.nf --study study.json --out DIR --shards 16
// Not run in the tests, which have no Nextflow.
params.study = 'study.json'
params.out = 'figures'
params.shards = 16

// A path as one word of the shell.
def quoted(path) {
    "'" + path.toString().replace("'", "'\\''") + "'"
}

process RUN_SHARD {
    cpus 1
    errorStrategy 'retry'
    maxRetries 3

    input:
    val study
    val out
    val index

    output:
    val index

    script:
    """
    slipgap run ${quoted(study)} --out ${quoted(out)} --jobs ${task.cpus} --shard ${index}/${params.shards}
    """
}

process MERGE_SHARDS {
    input:
    val study
    val out
    val shards

    output:
    stdout

    script:
    """
    # 3: a case has no solution, which failures.csv names; the results are complete.
    slipgap merge ${quoted(study)} --out ${quoted(out)} --shards ${shards.size()} || [ \$? -eq 3 ]
    """
}

workflow {
    // Values, not files that are linked into the folder of a task: results go to one folder.
    study = file(params.study, checkIfExists: true).toAbsolutePath()
    out = file(params.out).toAbsolutePath()
    done = RUN_SHARD(study, out, channel.of(1..(params.shards as Integer)))
    MERGE_SHARDS(study, out, done.collect()).view()
}
