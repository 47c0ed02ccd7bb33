/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time of a ticket: all processes but the first draw numbers from a counter that the first one keeps. */

#include <mpi.h>
#include <stdio.h>

enum { n_tickets = 100000 };

int main(int argc, char **argv)
{
   MPI_Init(&argc, &argv);
   int rank;
   MPI_Comm_rank(MPI_COMM_WORLD, &rank);
   long *counter;
   MPI_Win window;
   MPI_Win_allocate(rank == 0 ? sizeof *counter : 0, sizeof *counter, MPI_INFO_NULL, MPI_COMM_WORLD, &counter, &window);
   if (rank == 0) *counter = 0;
   MPI_Barrier(MPI_COMM_WORLD);
   MPI_Win_lock_all(0, window);
   const double start = MPI_Wtime();
   if (rank > 0) {
      const long one = 1;
      long ticket;
      for (int i = 0; i < n_tickets; i++) {
         MPI_Fetch_and_op(&one, &ticket, MPI_LONG, 0, 0, MPI_SUM, window);
         MPI_Win_flush(0, window);
      }
      if (rank == 1) printf("%.6e\n", (MPI_Wtime() - start)/n_tickets);
   }
   MPI_Win_unlock_all(window);
   MPI_Win_free(&window);
   MPI_Finalize();
   return 0;
}
