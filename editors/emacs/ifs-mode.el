;;; ifs-mode.el --- Designs of free-form timber as equations  -*- lexical-binding: t; -*-

;; Version: 0.1.0
;; Package-Requires: ((emacs "28.1"))

;;; Commentary:

;; A mode for .ifs files, and their language server (`ifs lsp') under eglot: `M-x eglot' in a design starts it.

;;; Code:

(defgroup ifs nil "Designs of free-form timber." :group 'languages)

(defcustom ifs-program "ifs" "The ifs program." :type 'string :group 'ifs)

(defvar ifs-mode-syntax-table
  (let ((table (make-syntax-table)))
    (modify-syntax-entry ?/ ". 12" table)
    (modify-syntax-entry ?\n ">" table)
    (modify-syntax-entry ?_ "_" table)
    (modify-syntax-entry ?\" "\"" table)
    table))

(defconst ifs-reserved-words
  '("use" "pub" "param" "let" "fn" "record" "ifs" "figure" "fabricate" "test" "if" "then" "else" "for" "in" "on" "at"
    "self" "true" "false"))

(defconst ifs-words-in-their-place
  '("transform" "germ" "keep" "boundary" "join" "require" "assert" "level" "until" "each" "step" "and" "or" "not" "by" "as"))

(defvar ifs-font-lock-keywords
  `((,(regexp-opt ifs-reserved-words 'symbols) . font-lock-keyword-face)
    (,(concat (regexp-opt ifs-words-in-their-place 'symbols) "\\(?:[ \t]+[^ \t:=]\\)") 1 font-lock-keyword-face)
    ("\\_<\\(?:fn\\|ifs\\)[ \t]+\\([a-z_][a-z0-9_]*\\)" 1 font-lock-function-name-face)
    ("\\_<[A-Z][A-Za-z0-9]*\\_>" . font-lock-type-face)
    ("\\_<\\([a-z_][a-z0-9_]*\\)[ \t]*:" 1 font-lock-variable-name-face)))

;;;###autoload
(define-derived-mode ifs-mode prog-mode "ifs"
  "Designs of free-form timber."
  (setq-local comment-start "// " comment-end "" indent-tabs-mode nil tab-width 4)
  (setq-local font-lock-defaults '(ifs-font-lock-keywords))
  (setq-local indent-line-function #'ifs-indent-line))

(defun ifs-indent-line ()
  "Indent by four columns for every bracket that is open where the line begins."
  (interactive)
  (let ((column (save-excursion
                  (back-to-indentation)
                  (let ((depth (car (syntax-ppss))))
                    (when (looking-at "[])}]") (setq depth (1- depth)))
                    (* 4 (max 0 depth))))))
    (if (<= (current-column) (current-indentation))
        (indent-line-to column)
      (save-excursion (indent-line-to column)))))

;;;###autoload
(add-to-list 'auto-mode-alist '("\\.ifs\\'" . ifs-mode))

(with-eval-after-load 'eglot
  (add-to-list 'eglot-server-programs `((ifs-mode) . (,ifs-program "lsp"))))

(provide 'ifs-mode)
;;; ifs-mode.el ends here
