// The conformance kit, tests/conformance/kit.json, as data of the program.
    .section .rodata
    .global certet_kit_begin
    .global certet_kit_end
certet_kit_begin:
    .incbin CERTET_KIT
certet_kit_end:
    .section .note.GNU-stack, "", %progbits
