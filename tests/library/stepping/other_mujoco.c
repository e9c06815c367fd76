/* All that a MuJoCo of another version needs to be told: it stands before the library's own. */
int mj_version(void);
int mj_version(void) { return 3012000; }
