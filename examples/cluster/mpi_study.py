"""A study on MPI: mpirun -n 8 python -m mpi4py.futures mpi_study.py FOLDER (one rank hands out rows, the others run them)."""

import sys

import archard
from mpi4py.futures import MPIPoolExecutor

if __name__ == "__main__":
    case = archard.Case("pin_on_disc")
    over = {"motion.sliding.load": ["5 N", "10 N", "15 N", "20 N"]}
    with MPIPoolExecutor() as executor:
        study = archard.sweep(case, over, executor=executor, out=sys.argv[1])
    print(study, *study.table["wear_depth_m"], sep="\n")
