"""Collections of models: fields of all of them, kept in a store, and how far they are apart.

>>> from pygirth import collection
>>> models = collection.fields(files, client=client, store="fields")   # a dask.distributed client, or none
>>> models.distances("igf")                                            # the whole matrix, in blocks
>>> numbers, distances = models.nearest("igf", k=10)                   # without the whole matrix
"""

from pygirth.collection._collection import Collection, Neighbours, fields
from pygirth.collection._store import NAMES

__all__ = ["NAMES", "Collection", "Neighbours", "fields"]
