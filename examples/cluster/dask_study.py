"""A study on Dask, here on this machine: python dask_study.py FOLDER.

On a cluster take `dask_jobqueue.SLURMCluster` in the place of `LocalCluster`. The row of a worker that is killed is tried
again by another one, `retries` times, and goes on where it was; rows that are done are not run again, also when the script
is started anew.
"""

import sys

import archard
from distributed import Client, LocalCluster

if __name__ == "__main__":
    case = archard.Case("pin_on_disc")
    over = {
        "motion.sliding.load": ["5 N", "10 N", "15 N", "20 N"],
        "body.pin.profile.sphere.radius": ["25 mm", "35 mm", "50 mm"],
    }
    with LocalCluster(n_workers=2, threads_per_worker=1) as cluster, Client(cluster) as client:
        study = archard.sweep(case, over, executor=client.get_executor(retries=3), out=sys.argv[1])
    print(study, *study.table["wear_depth_m"], sep="\n")
