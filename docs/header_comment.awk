# Makes the comment at the head of a header, after its licence, the documentation of the file.
NR == 1 { print; next }
!ended && /^\/\// {
    line = $0
    sub(/^\/\/ ?/, "", line)
    print (begun ? "/// " : "/// \\file\n/// ") line
    begun = 1
    next
}
{ ended = 1; print }
