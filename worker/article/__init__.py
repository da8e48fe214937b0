"""``tracksweep article``: what the article reports, reproduced, beside its numbers.

One noun per module: ``reported`` is what the article prints, ``studies`` what is computed for it, ``gathered`` how that
comes from the service, ``results`` what is kept of it, ``outcome`` what follows, ``claims`` what the article says in
words, ``figures`` and ``report`` what is written. ``strip`` is an experiment apart: the joint as the article has it.
"""
